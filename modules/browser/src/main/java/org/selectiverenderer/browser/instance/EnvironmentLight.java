package org.selectiverenderer.browser.instance;

import java.util.Optional;
import org.joml.Matrix4dc;

/**
 * Image-based lighting as given by an EnvironmentLight node (draft of X3D 4.1, 17.4). Immutable.
 *
 * @param diffuse the light that a white diffuse surface reflects, as a function of its normal: nine
 *     coefficients of spherical harmonics up to degree 2 (00, 1-1, 10, 11, 2-2, 2-1, 20, 21, 22),
 *     each with linear red, green and blue, multiplied by the light's colour and intensity
 * @param image the cube map for specular reflection, if there is one
 * @param color the factor of the specular reflection: red, green and blue times intensity
 * @param place the matrix from the light's coordinates, turned by its rotation, to the world
 */
public record EnvironmentLight(
    float[] diffuse, Optional<CubeTexture> image, float[] color, Matrix4dc place) {}
