// How far one picture is from another, as numbers. All accumulate in double.
//
// Every function throws std::invalid_argument when the sizes differ or a picture is empty.
// nlohmann::json writes an infinity as null, which is how reports show the two cases below.
#ifndef PLUME_MEASURE_METRICS_H
#define PLUME_MEASURE_METRICS_H

#include "sandbox/measure/image.h"

namespace plume {

/// Root of the mean squared difference over all pixels and the three channels, in linear radiance. A NaN, or
/// an infinity that the other picture does not have in that place, makes it infinite.
double rmse(const Image& a, const Image& b);

struct MaxError {
  double value = 0.0;  ///< linear radiance
  int x = 0;           ///< column of the pixel that has it, the first in reading order
  int y = 0;
};

/// The largest |a - b| of any channel of any pixel. Infinite where rmse is.
MaxError max_abs(const Image& a, const Image& b);

/// Peak signal-to-noise ratio in dB, 10 log10(255^2 / MSE) over all pixels and channels of the sRGB values.
/// Infinity for identical pictures.
double psnr_db(const DisplayImage& a, const DisplayImage& b);

/// Structural similarity, at most 1 and 1 only for pictures of equal luma: Wang, Bovik, Sheikh, Simoncelli,
/// "Image Quality Assessment: From Error Visibility to Structural Similarity", IEEE TIP 13(4), 2004, section
/// III, with its 11x11 Gaussian window (sigma 1.5), K1 = 0.01, K2 = 0.03, L = 255, on the Rec. 601 luma of
/// the sRGB values. The mean is over the pixels whose window lies inside the picture. A picture with a side
/// under 11 has none, so there every pixel counts and windows see the border pixels repeated outwards.
double ssim(const DisplayImage& a, const DisplayImage& b);

}  // namespace plume
#endif
