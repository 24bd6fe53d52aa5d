#include <umbrage/umbrage.hpp>
