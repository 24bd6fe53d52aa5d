// SPDX-License-Identifier: MIT
#include "written_order.hpp"

extern "C" {
extern const parity::written_order written_order;
const parity::written_order written_order{&parity::entries, &parity::make_job, &parity::make_whole_job};
}
