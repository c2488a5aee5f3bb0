package org.selectiverenderer.runtime.instance;

import java.util.Optional;
import org.joml.Matrix4dc;

/**
 * Light from all around, as an EnvironmentLight gives it (draft of X3D 4.1, 17.4). One immutable
 * value.
 *
 * @param diffuse what a white matt surface throws back, by its normal: nine coefficients of
 *     spherical harmonics up to the second degree (00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22), red,
 *     green and blue of each, as amounts of light; colour and intensity of the light are in them
 * @param image what is mirrored, if there is an image
 * @param color of what is mirrored, red, green and blue times intensity
 * @param place from the light's coordinates, turned by its rotation, to the world
 */
public record Environment(
    float[] diffuse, Optional<CubeTexture> image, float[] color, Matrix4dc place) {}
