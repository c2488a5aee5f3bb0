package org.selectiverenderer.radiosity.reference;

import java.util.Locale;
import org.selectiverenderer.radiosity.scene.Photometry;

/**
 * The Cornell box as it was measured: Cornell University Program of Computer Graphics, "Cornell Box
 * Data" (graphics.cornell.edu/online/box/data.html, now bowers.cornell.edu/computer-graphics/data).
 * Millimetres there, metres here; the axes are the same. Spectra every 4 nm from 400 to 700 nm. The
 * light's spectrum is given in no unit: its hue is as measured, its red is {@code emissiveColor} 1.
 * The ceiling has a hole where the light is, in the same plane.
 */
final class CornellBox {
  static final Spectrum WHITE =
      new Spectrum(
          0.343, 0.445, 0.551, 0.624, 0.665, 0.687, 0.708, 0.723, 0.715, 0.710, 0.745, 0.758, 0.739,
          0.767, 0.777, 0.765, 0.751, 0.745, 0.748, 0.729, 0.745, 0.757, 0.753, 0.750, 0.746, 0.747,
          0.735, 0.732, 0.739, 0.734, 0.725, 0.721, 0.733, 0.725, 0.732, 0.743, 0.744, 0.748, 0.728,
          0.716, 0.733, 0.726, 0.713, 0.740, 0.754, 0.764, 0.752, 0.736, 0.734, 0.741, 0.740, 0.732,
          0.745, 0.755, 0.751, 0.744, 0.731, 0.733, 0.744, 0.731, 0.712, 0.708, 0.729, 0.730, 0.727,
          0.707, 0.703, 0.729, 0.750, 0.760, 0.751, 0.739, 0.724, 0.730, 0.740, 0.737);

  static final Spectrum GREEN =
      new Spectrum(
          0.092, 0.096, 0.098, 0.097, 0.098, 0.095, 0.095, 0.097, 0.095, 0.094, 0.097, 0.098, 0.096,
          0.101, 0.103, 0.104, 0.107, 0.109, 0.112, 0.115, 0.125, 0.140, 0.160, 0.187, 0.229, 0.285,
          0.343, 0.390, 0.435, 0.464, 0.472, 0.476, 0.481, 0.462, 0.447, 0.441, 0.426, 0.406, 0.373,
          0.347, 0.337, 0.314, 0.285, 0.277, 0.266, 0.250, 0.230, 0.207, 0.186, 0.171, 0.160, 0.148,
          0.141, 0.136, 0.130, 0.126, 0.123, 0.121, 0.122, 0.119, 0.114, 0.115, 0.117, 0.117, 0.118,
          0.120, 0.122, 0.128, 0.132, 0.139, 0.144, 0.146, 0.150, 0.152, 0.157, 0.159);

  static final Spectrum RED =
      new Spectrum(
          0.040, 0.046, 0.048, 0.053, 0.049, 0.050, 0.053, 0.055, 0.057, 0.056, 0.059, 0.057, 0.061,
          0.061, 0.060, 0.062, 0.062, 0.062, 0.061, 0.062, 0.060, 0.059, 0.057, 0.058, 0.058, 0.058,
          0.056, 0.055, 0.056, 0.059, 0.057, 0.055, 0.059, 0.059, 0.058, 0.059, 0.061, 0.061, 0.063,
          0.063, 0.067, 0.068, 0.072, 0.080, 0.090, 0.099, 0.124, 0.154, 0.192, 0.255, 0.287, 0.349,
          0.402, 0.443, 0.487, 0.513, 0.558, 0.584, 0.620, 0.606, 0.609, 0.651, 0.612, 0.610, 0.650,
          0.638, 0.627, 0.620, 0.630, 0.628, 0.642, 0.639, 0.657, 0.639, 0.635, 0.642);

  /** Every 100 nm. */
  static final Spectrum LAMP = new Spectrum(0.0, 8.0, 15.6, 18.4);

  private static final double[] LAMP_SURFACE = {0.78, 0.78, 0.78};

  /** 35 mm before a film of 25 mm by 25 mm. */
  private static final double VIEW = 2 * StrictMath.atan(12.5 / 35);

  private static final String FLOOR = "552.8 0 0, 0 0 0, 0 0 559.2, 549.6 0 559.2";
  private static final String BACK = "549.6 0 559.2, 0 0 559.2, 0 548.8 559.2, 556 548.8 559.2";
  private static final String RIGHT = "0 0 559.2, 0 0 0, 0 548.8 0, 0 548.8 559.2";
  private static final String LEFT = "552.8 0 0, 549.6 0 559.2, 556 548.8 559.2, 556 548.8 0";
  private static final String LIGHT = "343 548.8 227, 343 548.8 332, 213 548.8 332, 213 548.8 227";

  /** Around the hole. */
  private static final String CEILING =
      "556 548.8 0, 556 548.8 227, 0 548.8 227, 0 548.8 0,"
          + "556 548.8 332, 556 548.8 559.2, 0 548.8 559.2, 0 548.8 332,"
          + "556 548.8 227, 556 548.8 332, 343 548.8 332, 343 548.8 227,"
          + "213 548.8 227, 213 548.8 332, 0 548.8 332, 0 548.8 227";

  private static final String SHORT_BLOCK =
      "130 165 65, 82 165 225, 240 165 272, 290 165 114,"
          + "290 0 114, 290 165 114, 240 165 272, 240 0 272,"
          + "130 0 65, 130 165 65, 290 165 114, 290 0 114,"
          + "82 0 225, 82 165 225, 130 165 65, 130 0 65,"
          + "240 0 272, 240 165 272, 82 165 225, 82 0 225";

  private static final String TALL_BLOCK =
      "423 330 247, 265 330 296, 314 330 456, 472 330 406,"
          + "423 0 247, 423 330 247, 472 330 406, 472 0 406,"
          + "472 0 406, 472 330 406, 314 330 456, 314 0 456,"
          + "314 0 456, 314 330 456, 265 330 296, 265 0 296,"
          + "265 0 296, 265 330 296, 423 330 247, 423 0 247";

  private CornellBox() {}

  /** The scene as an X3D file. */
  static String x3d() {
    double[] white = WHITE.ofSurface();
    double[] lamp = LAMP.ofLight();
    double most = Math.max(lamp[0], Math.max(lamp[1], lamp[2]));
    for (int i = 0; i < 3; i++) {
      lamp[i] /= most;
    }
    String head =
        """
        <?xml version="1.0" encoding="UTF-8"?>
        <X3D profile='Immersive' version='3.3'>
          <Scene>
            <WorldInfo title='The Cornell box' info='"Cornell University Program of Computer Graphics, Cornell Box Data"'/>
            <NavigationInfo type='"EXAMINE" "ANY"' headlight='false'/>
            <Viewpoint DEF='Camera' position='0.278 0.273 -0.8' orientation='0 1 0 3.14159265' fieldOfView='%s'/>
        """;
    return String.format(Locale.ROOT, head, String.format(Locale.ROOT, "%.6f", VIEW))
        + shape("Floor", FLOOR, "diffuseColor", white)
        + shape("Ceiling", CEILING, "diffuseColor", white)
        + shape("Back", BACK, "diffuseColor", white)
        + shape("Right", RIGHT, "diffuseColor", GREEN.ofSurface())
        + shape("Left", LEFT, "diffuseColor", RED.ofSurface())
        + shape("ShortBlock", SHORT_BLOCK, "diffuseColor", white)
        + shape("TallBlock", TALL_BLOCK, "diffuseColor", white)
        + shape("Light", LIGHT, colour("diffuseColor", LAMP_SURFACE) + " emissiveColor", lamp)
        + "  </Scene>\n</X3D>\n";
  }

  private static String colour(String field, double[] linear) {
    return String.format(
        Locale.ROOT,
        "%s='%.4f %.4f %.4f'",
        field,
        Photometry.display(linear[0]),
        Photometry.display(linear[1]),
        Photometry.display(linear[2]));
  }

  private static String shape(String name, String millimetres, String field, double[] linear) {
    String[] points = millimetres.split(",");
    StringBuilder metres = new StringBuilder();
    StringBuilder index = new StringBuilder();
    for (int i = 0; i < points.length; i++) {
      String[] xyz = points[i].strip().split(" ");
      metres.append(i == 0 ? "" : ", ");
      for (int axis = 0; axis < 3; axis++) {
        double value = Double.parseDouble(xyz[axis]) / 1000;
        metres.append(axis == 0 ? "" : " ").append(String.format(Locale.ROOT, "%.4f", value));
      }
      index.append(i == 0 ? "" : " ").append(i).append(i % 4 == 3 ? " -1" : "");
    }
    return """
        <Shape DEF='%s'>
          <Appearance><Material %s/></Appearance>
          <IndexedFaceSet coordIndex='%s'>
            <Coordinate point='%s'/>
          </IndexedFaceSet>
        </Shape>
    """
        .formatted(name, colour(field, linear), index, metres);
  }
}
