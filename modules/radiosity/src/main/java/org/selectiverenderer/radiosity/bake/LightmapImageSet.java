package org.selectiverenderer.radiosity.bake;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.atlas.AtlasPage;
import org.selectiverenderer.radiosity.scene.Body;

/**
 * Turns the pages of irradiance into lightmap images: the colour of each texel is the tone-mapped
 * radiance of its surface point, emission + reflectance * irradiance / pi. Where a surface's own
 * texture stays, the lightmap has that colour divided by the texture's mean colour, both
 * display-encoded: so the product of texture and lightmap is the tone-mapped colour where the
 * texture has its mean, and deviates elsewhere as far as the tone curve deviates from a power
 * function. Where the light makes a surface brighter than its texture, the texture is brightened as
 * far as it can be and the lightmap darkened by the same factor ({@link BrightenedImage}).
 */
public final class LightmapImageSet {
  /** Share of a body's texels that may be too bright for its texture before that is brightened. */
  private static final double TOO_BRIGHT = 0.002;

  private static final double LEAST_OPAQUE = 0.05;

  private final LightmappedScene lit;
  private final TextureBakePlan use;
  private final BitSet brighter = new BitSet();
  private final List<LightmapImage> pictures;

  private LightmapImageSet(LightmappedScene lit) {
    this.lit = lit;
    use = TextureBakePlan.of(lit.scene(), lit.atlas().pages());
    int count = lit.atlas().pages().size();
    LightmapImage[] made = new LightmapImage[count];
    IntStream.range(0, count).parallel().forEach(page -> made[page] = picture(page));
    pictures = new ArrayList<>(Arrays.asList(made));
  }

  /** Computes the images of all pages, on all processors. */
  public static LightmapImageSet of(LightmappedScene lit) {
    return new LightmapImageSet(lit);
  }

  /** Returns the images in the order of the atlas's pages. */
  public List<LightmapImage> pictures() {
    return pictures;
  }

  public TextureBakePlan use() {
    return use;
  }

  /** Returns whether a body's texture is to be replaced by its {@link BrightenedImage}. */
  public boolean brighter(int body) {
    return brighter.get(body);
  }

  private LightmapImage picture(int number) {
    AtlasPage page = lit.atlas().pages().get(number);
    float[] colours = new float[3 * page.texels()];
    int[] bodies = new int[page.texels()];
    paint(page, lit.pages().irradiance().get(number), colours, bodies);
    BitSet bright = bright(colours, bodies);
    synchronized (brighter) {
      brighter.or(bright);
    }
    darken(colours, bodies, bright);
    GutterDilation.fill(page.width(), page.height(), bodies, colours);
    return new LightmapImage(page.width(), page.height(), bytes(page, colours));
  }

  private void paint(AtlasPage page, float[] irradiance, float[] colours, int[] bodies) {
    Body body = null;
    TexelReflectance paint = null;
    double[] shown = {1, 1, 1};
    int last = -1;
    double[] reflectance = new double[3];
    double[] radiance = new double[3];
    for (int texel = 0; texel < page.texels(); texel++) {
      int triangle = page.triangle()[texel];
      int number = triangle == AtlasPage.NONE ? -1 : lit.scene().bodyOf()[triangle];
      bodies[texel] = number;
      if (number < 0) {
        continue;
      }
      if (number != last || body == null || paint == null) {
        body = lit.scene().bodies().get(number);
        paint = use.paint(body, number);
        shown = use.shown(number);
        last = number;
      }
      paint.reflectance(
          triangle - body.firstTriangle(), page.u()[texel], page.v()[texel], reflectance);
      // A transparent surface is blended with what lies behind it by its alpha, so its colour is
      // that of the opaque share alone.
      double opaque = Math.max(LEAST_OPAQUE, 1 - body.transmittance());
      for (int c = 0; c < 3; c++) {
        double light = reflectance[c] * irradiance[3 * texel + c] / Math.PI;
        radiance[c] = (body.emission()[c] + light) / opaque;
      }
      lit.curve().colour(radiance[0], radiance[1], radiance[2], colours, 3 * texel);
      for (int c = 0; c < 3; c++) {
        colours[3 * texel + c] /= (float) shown[c];
      }
    }
  }

  private void darken(float[] colours, int[] bodies, BitSet bright) {
    Map<Integer, double[]> gains = new HashMap<>();
    bright.stream().forEach(body -> gains.put(body, use.gains(body)));
    for (int texel = 0; texel < bodies.length; texel++) {
      double[] gain = gains.get(bodies[texel]);
      for (int c = 0; gain != null && c < 3; c++) {
        colours[3 * texel + c] /= (float) gain[c];
      }
    }
  }

  /** Returns the bodies too many of whose texels are brighter than white. */
  private BitSet bright(float[] colours, int[] bodies) {
    int[] all = new int[lit.scene().bodies().size()];
    int[] over = new int[all.length];
    for (int texel = 0; texel < bodies.length; texel++) {
      int body = bodies[texel];
      if (body >= 0 && use.apart(body)) {
        int at = 3 * texel;
        all[body]++;
        over[body] += Math.max(colours[at], Math.max(colours[at + 1], colours[at + 2])) > 1 ? 1 : 0;
      }
    }
    BitSet bright = new BitSet();
    for (int body = 0; body < all.length; body++) {
      bright.set(body, over[body] > TOO_BRIGHT * all[body] && max(use.gains(body)) > 1);
    }
    return bright;
  }

  private static double max(double[] three) {
    return Math.max(three[0], Math.max(three[1], three[2]));
  }

  private static byte[] bytes(AtlasPage page, float[] colours) {
    int row = 3 * page.width();
    byte[] rgb = new byte[colours.length];
    for (int y = 0; y < page.height(); y++) {
      int from = (page.height() - 1 - y) * row;
      for (int i = 0; i < row; i++) {
        rgb[y * row + i] = (byte) Math.min(255, Math.round(255 * colours[from + i]));
      }
    }
    return rgb;
  }

  /**
   * Dilates charts into the gutters between them: each gutter texel takes the colour of the nearest
   * texel of a chart, so that minification filters mix in no foreign colour.
   */
  private static final class GutterDilation {
    private GutterDilation() {}

    /**
     * Fills the texels that belong to no body.
     *
     * @param owners per texel: the number of its body, 0 or above, or -1 for none
     * @param colours r, g, b per texel; those of gutters are overwritten
     */
    static void fill(int width, int height, int[] owners, float[] colours) {
      int[] queue = new int[owners.length];
      boolean[] filled = new boolean[owners.length];
      int end = 0;
      for (int texel = 0; texel < owners.length; texel++) {
        if (owners[texel] >= 0) {
          filled[texel] = true;
          queue[end++] = texel;
        }
      }
      for (int at = 0; at < end; at++) {
        int texel = queue[at];
        int x = texel % width;
        end = spread(texel, x > 0 ? texel - 1 : texel, colours, filled, queue, end);
        end = spread(texel, x < width - 1 ? texel + 1 : texel, colours, filled, queue, end);
        end = spread(texel, texel >= width ? texel - width : texel, colours, filled, queue, end);
        int above = texel + width;
        end = spread(texel, above < width * height ? above : texel, colours, filled, queue, end);
      }
    }

    private static int spread(
        int from, int to, float[] colours, boolean[] filled, int[] queue, int end) {
      if (filled[to]) {
        return end;
      }
      filled[to] = true;
      System.arraycopy(colours, 3 * from, colours, 3 * to, 3);
      queue[end] = to;
      return end + 1;
    }
  }
}
