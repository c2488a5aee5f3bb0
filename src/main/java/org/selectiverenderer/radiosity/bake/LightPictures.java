package org.selectiverenderer.radiosity.bake;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.stream.IntStream;
import org.selectiverenderer.radiosity.atlas.TexelMap;
import org.selectiverenderer.radiosity.scene.Body;

/**
 * The pages of light as pictures: the colour of each texel is the tone curve of what its place
 * sends out, emission + reflectance * irradiance / pi. Where a surface's image stays a texture of
 * its own, the picture has that colour by the image's mean colour, as a display is given both: so
 * their product is the tone curve's colour where the image has its mean, and elsewhere as far from
 * it as the curve is from a power. Where the light makes it brighter than the image, the picture
 * has half of it and is to be multiplied twice ({@code MODULATE2X}).
 */
public final class LightPictures {
  /** The share of a body's texels that may be too bright before it is halved. */
  private static final double TOO_BRIGHT = 0.002;

  private static final double LEAST_OPAQUE = 0.05;

  private final TexelScene lit;
  private final TextureUse use;
  private final BitSet doubled = new BitSet();
  private final List<LightPicture> pictures;

  private LightPictures(TexelScene lit) {
    this.lit = lit;
    use = TextureUse.of(lit.scene(), lit.atlas().pages());
    int count = lit.atlas().pages().size();
    LightPicture[] made = new LightPicture[count];
    IntStream.range(0, count).parallel().forEach(page -> made[page] = picture(page));
    pictures = new ArrayList<>(Arrays.asList(made));
  }

  /** Paints all pages; on all processors. */
  public static LightPictures of(TexelScene lit) {
    return new LightPictures(lit);
  }

  /** By the pages of the atlas. */
  public List<LightPicture> pictures() {
    return pictures;
  }

  public TextureUse use() {
    return use;
  }

  /** Whether a body's image is to be multiplied by its picture twice. */
  public boolean doubled(int body) {
    return doubled.get(body);
  }

  private LightPicture picture(int number) {
    TexelMap page = lit.atlas().pages().get(number);
    float[] colours = new float[3 * page.texels()];
    int[] bodies = new int[page.texels()];
    paint(page, lit.pages().irradiance().get(number), colours, bodies);
    BitSet halved = halved(colours, bodies);
    synchronized (doubled) {
      doubled.or(halved);
    }
    for (int texel = 0; texel < bodies.length; texel++) {
      if (bodies[texel] >= 0 && halved.get(bodies[texel])) {
        for (int c = 0; c < 3; c++) {
          colours[3 * texel + c] /= 2;
        }
      }
    }
    Gutters.fill(page.width(), page.height(), bodies, colours);
    return new LightPicture(page.width(), page.height(), bytes(page, colours));
  }

  private void paint(TexelMap page, float[] irradiance, float[] colours, int[] bodies) {
    Body body = null;
    BodyPaint paint = null;
    double[] shown = {1, 1, 1};
    int last = -1;
    double[] reflectance = new double[3];
    double[] radiance = new double[3];
    for (int texel = 0; texel < page.texels(); texel++) {
      int triangle = page.triangle()[texel];
      int number = triangle == TexelMap.NONE ? -1 : lit.scene().bodyOf()[triangle];
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
      // What is transparent is mixed with what lies behind by its alpha: its colour is that of
      // the opaque share alone.
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

  /** The bodies too many of whose texels are brighter than a picture can be. */
  private BitSet halved(float[] colours, int[] bodies) {
    int[] all = new int[lit.scene().bodies().size()];
    int[] bright = new int[all.length];
    for (int texel = 0; texel < bodies.length; texel++) {
      int body = bodies[texel];
      if (body >= 0 && use.apart(body)) {
        int at = 3 * texel;
        all[body]++;
        bright[body] +=
            Math.max(colours[at], Math.max(colours[at + 1], colours[at + 2])) > 1 ? 1 : 0;
      }
    }
    BitSet halved = new BitSet();
    for (int body = 0; body < all.length; body++) {
      halved.set(body, bright[body] > TOO_BRIGHT * all[body]);
    }
    return halved;
  }

  private static byte[] bytes(TexelMap page, float[] colours) {
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
}
