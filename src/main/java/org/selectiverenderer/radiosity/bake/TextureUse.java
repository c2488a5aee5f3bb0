package org.selectiverenderer.radiosity.bake;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.scene.Body;
import org.selectiverenderer.radiosity.scene.LightScene;
import org.selectiverenderer.radiosity.scene.Photometry;

/**
 * What becomes of the images that lie on bodies. One with about as many pixels as the light there
 * has texels becomes part of the light's picture. One with more, because it is finer or repeats,
 * and one with holes, stays a texture of its own; the light's picture is multiplied with it.
 */
public final class TextureUse {
  /** Pixels for each texel up to which an image becomes part of the light's picture. */
  static final double FEW = 1.5;

  /** A mean darker than this is taken for this: what is black stays black by itself. */
  private static final double LEAST = 1e-3;

  /**
   * One body's.
   *
   * @param own the image on it, or null
   * @param mean of the image over the body, shares of light, if it stays apart; else null
   */
  private record Use(@Nullable OwnTexture own, double @Nullable [] mean) {}

  private final List<Use> uses;

  private TextureUse(List<Use> uses) {
    this.uses = uses;
  }

  /** The use of all images of a scene whose light is in these pages. */
  static TextureUse of(LightScene scene, List<TexelMap> pages) {
    int bodies = scene.bodies().size();
    long[] texels = new long[bodies];
    for (TexelMap page : pages) {
      for (int triangle : page.triangle()) {
        if (triangle != TexelMap.NONE) {
          texels[scene.bodyOf()[triangle]]++;
        }
      }
    }
    List<@Nullable OwnTexture> own = new ArrayList<>();
    boolean[] apart = new boolean[bodies];
    for (int i = 0; i < bodies; i++) {
      Body body = scene.bodies().get(i);
      OwnTexture texture = OwnTexture.on(body) ? OwnTexture.of(body) : null;
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
    return new TextureUse(uses);
  }

  private static double[][] sums(
      LightScene scene, List<TexelMap> pages, List<@Nullable OwnTexture> own, boolean[] apart) {
    double[][] sums = new double[apart.length][4];
    double[] st = new double[2];
    double[] rgba = new double[4];
    for (TexelMap page : pages) {
      for (int texel = 0; texel < page.texels(); texel++) {
        int triangle = page.triangle()[texel];
        int body = triangle == TexelMap.NONE ? -1 : scene.bodyOf()[triangle];
        OwnTexture texture = body < 0 || !apart[body] ? null : own.get(body);
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

  /** Bodies whose image stays a texture of its own. */
  public int apart() {
    return (int) uses.stream().filter(use -> use.mean() != null).count();
  }

  /** Whether a body's image stays a texture of its own. */
  public boolean apart(int body) {
    return uses.get(body).mean() != null;
  }

  /** What a brighter copy of a body's image would have; 1 where there is none. */
  double[] gains(int body) {
    OwnTexture own = uses.get(body).own();
    return own == null || !apart(body) || !own.copies()
        ? new double[] {1, 1, 1}
        : BrightImage.gains(own.texture().image());
  }

  BodyPaint paint(Body body, int number) {
    return new BodyPaint(body, uses.get(number).own(), uses.get(number).mean());
  }

  /** What a body's picture is divided by, as a display is given it: 1 unless its image is apart. */
  double[] shown(int body) {
    double[] mean = uses.get(body).mean();
    return mean == null
        ? new double[] {1, 1, 1}
        : new double[] {
          Photometry.display(mean[0]), Photometry.display(mean[1]), Photometry.display(mean[2])
        };
  }
}
