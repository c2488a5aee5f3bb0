package org.selectiverenderer.radiosity.bake;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.radiosity.scene.RadiosityScene;

/**
 * Decides for each body's own texture whether it is merged into the lightmap or stays. A texture
 * with about as many pixels as the lightmap has texels there is merged. One with more pixels,
 * because it is finer or repeats, and one with alpha stays a texture of its own, which the lightmap
 * is multiplied by.
 */
public final class TextureBakePlan {
  /** Pixels per texel up to which a texture is merged into the lightmap. */
  static final double FEW = 1.5;

  /** Least mean colour, which is divided by: a black texture stays black by itself. */
  private static final double LEAST = 1e-3;

  /**
   * The decision for one body.
   *
   * @param own the body's own texture, or null
   * @param mean mean linear colour of the texture over the body if it stays a texture of its own;
   *     else null
   */
  private record Use(@Nullable DiffuseTexture own, double @Nullable [] mean) {}

  private final List<Use> uses;

  private TextureBakePlan(List<Use> uses) {
    this.uses = uses;
  }

  /** Decides for all bodies of a scene whose light is in these pages. */
  static TextureBakePlan of(RadiosityScene scene, List<AtlasPage> pages) {
    int bodies = scene.bodies().size();
    long[] texels = new long[bodies];
    for (AtlasPage page : pages) {
      for (int triangle : page.triangle()) {
        if (triangle != AtlasPage.NONE) {
          texels[scene.bodyOf()[triangle]]++;
        }
      }
    }
    List<@Nullable DiffuseTexture> own = new ArrayList<>();
    boolean[] apart = new boolean[bodies];
    for (int i = 0; i < bodies; i++) {
      Body body = scene.bodies().get(i);
      DiffuseTexture texture = DiffuseTexture.on(body) ? DiffuseTexture.of(body) : null;
      own.add(texture);
      if (texture != null) {
        double pixels = texture.pixels();
        apart[i] =
            texture.node().isPresent()
                && pixels > 0
                && (texture.hasAlpha() || pixels > FEW * texels[i]);
      }
    }
    double[][] sums = sums(scene, pages, own, apart);
    List<Use> uses = new ArrayList<>();
    for (int i = 0; i < bodies; i++) {
      uses.add(new Use(own.get(i), apart[i] ? mean(sums[i]) : null));
    }
    return new TextureBakePlan(uses);
  }

  private static double[][] sums(
      RadiosityScene scene,
      List<AtlasPage> pages,
      List<@Nullable DiffuseTexture> own,
      boolean[] apart) {
    double[][] sums = new double[apart.length][4];
    double[] st = new double[2];
    double[] rgba = new double[4];
    for (AtlasPage page : pages) {
      for (int texel = 0; texel < page.texels(); texel++) {
        int triangle = page.triangle()[texel];
        int body = triangle == AtlasPage.NONE ? -1 : scene.bodyOf()[triangle];
        DiffuseTexture texture = body < 0 || !apart[body] ? null : own.get(body);
        if (texture != null) {
          int first = scene.bodies().get(body).firstTriangle();
          texture.place(triangle - first, page.u()[texel], page.v()[texel], st);
          texture.sample(st, rgba);
          for (int c = 0; c < 3; c++) {
            sums[body][c] += rgba[3] * rgba[c];
          }
          sums[body][3] += rgba[3];
        }
      }
    }
    return sums;
  }

  private static double[] mean(double[] sum) {
    double[] mean = new double[3];
    for (int c = 0; c < 3; c++) {
      mean[c] = sum[3] > 0 ? Math.max(LEAST, sum[c] / sum[3]) : 1;
    }
    return mean;
  }

  /** Returns the number of bodies whose texture stays a texture of its own. */
  public int apart() {
    return (int) uses.stream().filter(use -> use.mean() != null).count();
  }

  /** Returns whether a body's texture stays a texture of its own. */
  public boolean apart(int body) {
    return uses.get(body).mean() != null;
  }

  /** Returns the factors of a brightened copy of a body's texture; 1 where there is none. */
  double[] gains(int body) {
    DiffuseTexture own = uses.get(body).own();
    return own == null || !apart(body) || !own.copies()
        ? new double[] {1, 1, 1}
        : BrightenedImage.gains(own.texture().image());
  }

  TexelReflectance paint(Body body, int number) {
    return new TexelReflectance(body, uses.get(number).own(), uses.get(number).mean());
  }

  /**
   * Returns the display colour that a body's lightmap is divided by: the mean of its texture if
   * that stays a texture of its own, else 1.
   */
  double[] shown(int body) {
    double[] mean = uses.get(body).mean();
    return mean == null
        ? new double[] {1, 1, 1}
        : new double[] {
          Photometry.display(mean[0]), Photometry.display(mean[1]), Photometry.display(mean[2])
        };
  }
}
