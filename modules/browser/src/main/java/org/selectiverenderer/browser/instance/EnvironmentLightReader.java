package org.selectiverenderer.browser.instance;

import java.util.Optional;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/**
 * Reads an EnvironmentLight (draft of X3D 4.1, 17.4). Its {@code diffuseCoefficients} take
 * precedence over its {@code diffuseTexture}; without both, the diffuse light is computed from its
 * {@code specularTexture}.
 */
final class EnvironmentLightReader {
  private final Node node;
  private final AssetProvider assets;
  private Known known = new Known(Optional.empty(), Optional.empty(), new float[0]);
  private double[] harmonics = {};

  /** The field values from which the harmonics were computed. */
  private record Known(
      Optional<TextureSource> diffuse, Optional<TextureSource> specular, float[] coefficients) {
    boolean same(Known other) {
      return diffuse.equals(other.diffuse)
          && specular.equals(other.specular)
          && coefficients == other.coefficients;
    }
  }

  EnvironmentLightReader(Node node, AssetProvider assets) {
    this.node = node;
    this.assets = assets;
  }

  /**
   * Reads the light for the present field values; empty if it gives none. The harmonics are
   * computed again only if the images have changed.
   *
   * @param world the matrix from the node's coordinates to the world
   */
  Optional<EnvironmentLight> read(Matrix4dc world) {
    Known now =
        new Known(
            cube(node.node("diffuseTexture")),
            cube(node.node("specularTexture")),
            node.floats("diffuseCoefficients"));
    if (!now.same(known)) {
      known = now;
      harmonics = harmonics(now);
    }
    if (harmonics.length == 0) {
      return Optional.empty();
    }
    float[] color = node.floats("color").clone();
    for (int i = 0; i < 3; i++) {
      color[i] *= Math.max(0, node.number("intensity"));
    }
    float[] diffuse = new float[harmonics.length];
    for (int i = 0; i < diffuse.length; i++) {
      diffuse[i] = (float) harmonics[i] * color[i % 3];
    }
    return Optional.of(
        new EnvironmentLight(
            diffuse, now.specular().map(CubeTexture.class::cast), color, turned(world)));
  }

  private static double[] harmonics(Known now) {
    if (now.coefficients().length >= 3) {
      return SphericalHarmonics.ofFalling(now.coefficients());
    }
    return now.diffuse()
        .map(images -> SphericalHarmonics.of((CubeTexture) images, false))
        .or(() -> now.specular().map(images -> SphericalHarmonics.of((CubeTexture) images, true)))
        .orElseGet(() -> new double[0]);
  }

  private Optional<TextureSource> cube(@Nullable Node texture) {
    return TextureReader.read(texture, assets).filter(CubeTexture.class::isInstance);
  }

  private Matrix4d turned(Matrix4dc world) {
    float[] r = node.floats("rotation");
    double length = Math.sqrt(r[0] * (double) r[0] + r[1] * (double) r[1] + r[2] * (double) r[2]);
    Matrix4d place = new Matrix4d(world);
    return length > 0 ? place.rotate(r[3], r[0] / length, r[1] / length, r[2] / length) : place;
  }
}
