package org.selectiverenderer.radiosity.bake;

import java.util.Arrays;
import java.util.Optional;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.instance.SurfaceMaterial;
import org.selectiverenderer.browser.instance.Texture;
import org.selectiverenderer.browser.scene.Node;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.Photometry;

/**
 * The author's own texture of a body at full resolution: X3D 4.0, 18.2.1 (how its colours combine
 * with the material's) and 18.4.8 (coordinates changed by a TextureTransform).
 */
public final class DiffuseTexture {
  private static final Set<String> PLAIN = Set.of("ImageTexture", "PixelTexture", "MovieTexture");

  private final Body body;
  private final Texture texture;
  private final float[] coordinates;

  private DiffuseTexture(Body body, Texture texture, float[] coordinates) {
    this.body = body;
    this.texture = texture;
    this.coordinates = coordinates;
  }

  /** Returns whether a body has a texture and texture coordinates. */
  public static boolean on(Body body) {
    SurfaceMaterial surface = body.shape().surface();
    return surface.lit() && surface.texture() != null && body.mesh().hasTexCoords();
  }

  /**
   * Returns the texture of a body that has one.
   *
   * @throws IllegalArgumentException if the body has no texture
   */
  public static DiffuseTexture of(Body body) {
    Texture texture = body.shape().surface().texture();
    float[] given = body.mesh().texCoords();
    if (texture == null || given == null) {
      throw new IllegalArgumentException("a body without a texture");
    }
    return new DiffuseTexture(
        body, texture, turned(given, body.shape().surface().textureTransform()));
  }

  private static float[] turned(float[] given, float @Nullable [] m) {
    if (m == null) {
      return given;
    }
    float[] out = new float[given.length];
    for (int i = 0; i < out.length; i += 2) {
      out[i] = m[0] * given[i] + m[3] * given[i + 1] + m[6];
      out[i + 1] = m[1] * given[i] + m[4] * given[i + 1] + m[7];
    }
    return out;
  }

  /**
   * Returns the node of an ImageTexture, PixelTexture or MovieTexture, which can be copied to the
   * lit file as it is; empty for any other texture.
   */
  public Optional<Node> node() {
    Node appearance = body.shape().node().node("appearance");
    Node material = appearance == null ? null : appearance.node("material");
    Node own =
        material == null || material.type().field("diffuseTexture").isEmpty()
            ? null
            : material.node("diffuseTexture");
    Node used = own != null || appearance == null ? own : appearance.node("texture");
    return Optional.ofNullable(used).filter(node -> PLAIN.contains(node.type().name()));
  }

  /** Returns the texture; bodies that share an image share this object. */
  public Texture texture() {
    return texture;
  }

  /** Returns whether a brightened copy can replace the image: not for films and layered images. */
  boolean copies() {
    return texture.image().film() == null && texture.image().layers() == 1;
  }

  /** Returns whether the texture multiplies the material's colour; otherwise it replaces it. */
  boolean tints() {
    return body.shape().surface().tints();
  }

  public int width() {
    return texture.image().width();
  }

  public int height() {
    return texture.image().height();
  }

  /** Returns whether the texture has an alpha channel that is not opaque everywhere. */
  public boolean hasAlpha() {
    return texture.image().translucent();
  }

  /**
   * Computes the texture coordinates at a point of a triangle of the body, with the
   * TextureTransform applied.
   *
   * @param u barycentric weight of its second corner
   * @param v barycentric weight of its third corner
   * @param out receives s and t
   */
  public void place(int triangle, double u, double v, double[] out) {
    double[] weights = {1 - u - v, u, v};
    out[0] = 0;
    out[1] = 0;
    for (int corner = 0; corner < 3; corner++) {
      int at = 2 * body.vertex(triangle, corner);
      out[0] += weights[corner] * coordinates[at];
      out[1] += weights[corner] * coordinates[at + 1];
    }
  }

  /**
   * Returns whether all texture coordinates lie on one line or point, so that they span no area.
   */
  public boolean flat() {
    return pixels() == 0;
  }

  /** Returns how many pixels of the image the body shows. */
  double pixels() {
    double sum = 0;
    for (int i = 0; i < body.triangles(); i++) {
      sum += pixels(i);
    }
    return sum;
  }

  /** Returns how many pixels of the image a triangle shows, repeated pixels counted each time. */
  private double pixels(int triangle) {
    double[] a = new double[2];
    double[] b = new double[2];
    double[] c = new double[2];
    place(triangle, 0, 0, a);
    place(triangle, 1, 0, b);
    place(triangle, 0, 1, c);
    double area = Math.abs((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2;
    return area * width() * height();
  }

  /**
   * Samples the image bilinearly, in linear light.
   *
   * @param st texture coordinates s and t
   * @param out receives r, g, b and alpha
   */
  void sample(double[] st, double[] out) {
    double x = st[0] * width() - 0.5;
    double y = st[1] * height() - 0.5;
    int left = (int) Math.floor(x);
    int low = (int) Math.floor(y);
    Arrays.fill(out, 0);
    for (int dy = 0; dy < 2; dy++) {
      for (int dx = 0; dx < 2; dx++) {
        double weight = (dx == 0 ? 1 - (x - left) : x - left) * (dy == 0 ? 1 - (y - low) : y - low);
        add(
            wrapped(left + dx, width(), texture.repeatS()),
            wrapped(low + dy, height(), texture.repeatT()),
            weight,
            out);
      }
    }
  }

  private void add(int x, int y, double weight, double[] out) {
    byte[] rgba = texture.image().rgba();
    int at = 4 * (y * width() + x);
    for (int c = 0; c < 3; c++) {
      out[c] += weight * LINEAR[rgba[at + c] & 0xff];
    }
    out[3] += weight * (rgba[at + 3] & 0xff) / 255;
  }

  private static int wrapped(int pixel, int size, boolean repeats) {
    return repeats ? Math.floorMod(pixel, size) : Math.max(0, Math.min(size - 1, pixel));
  }

  private static final float[] LINEAR = linear();

  private static float[] linear() {
    float[] all = new float[256];
    for (int i = 0; i < all.length; i++) {
      all[i] = Photometry.linear(i / 255.0);
    }
    return all;
  }
}
