// SPDX-License-Identifier: MIT
#include "opencv.hpp"

#include <type_traits>

#include <opencv2/imgproc.hpp>

namespace peers::opencv {
namespace {

const int one_thread = (cv::setNumThreads(1), 0);

/// The same pixels, not a copy.
template <class T>
cv::Mat mat(umbrage::image_view<T> view, int type) {
    return {view.size.y, view.size.x, type, const_cast<std::remove_const_t<T>*>(view.data),
            static_cast<std::size_t>(view.stride)};
}

}  // namespace

void gaussian_7(umbrage::image_view<const glm::vec2> from, umbrage::image_view<glm::vec2> to, double sigma) {
    cv::Mat result = mat(to, CV_32FC2);
    cv::GaussianBlur(mat(from, CV_32FC2), result, {7, 7}, sigma, sigma, cv::BORDER_REPLICATE);
}

void separable_7(umbrage::image_view<const glm::vec2> from, umbrage::image_view<glm::vec2> to,
                 std::span<const float, 7> kernel) {
    cv::Mat result = mat(to, CV_32FC2);
    const cv::Mat taps(1, 7, CV_32F, const_cast<float*>(kernel.data()));
    cv::sepFilter2D(mat(from, CV_32FC2), result, -1, taps, taps, {-1, -1}, 0.0, cv::BORDER_REPLICATE);
}

void integral(umbrage::image_view<const std::uint8_t> values, umbrage::image_view<std::uint32_t> sums) {
    cv::Mat result = mat(sums, CV_32S);
    cv::integral(mat(values, CV_8U), result, CV_32S);
}

void integral(umbrage::image_view<const float> values, umbrage::image_view<float> sums) {
    cv::Mat result = mat(sums, CV_32F);
    cv::integral(mat(values, CV_32F), result, CV_32F);
}

}  // namespace peers::opencv
