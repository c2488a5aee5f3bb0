package org.selectiverenderer.radiosity.output;

import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.base.problem.ProblemCollector;
import org.selectiverenderer.browser.instance.LightInstance;
import org.selectiverenderer.radiosity.bake.ReinhardToneMapping;
import org.selectiverenderer.radiosity.light.DirectionalLightSource;
import org.selectiverenderer.radiosity.light.LightSource;
import org.selectiverenderer.radiosity.light.PointLightSource;
import org.selectiverenderer.radiosity.light.RectangleLightSource;
import org.selectiverenderer.radiosity.scene.LightSourceReader;
import org.selectiverenderer.radiosity.scene.Photometry;
import org.selectiverenderer.x3d.catalogue.FieldDefinition;
import org.selectiverenderer.x3d.catalogue.NodeView;
import org.selectiverenderer.x3d.write.FieldValueFormatter;
import org.selectiverenderer.x3d.write.X3dWriter;

/**
 * Writes the lights that stay on for specular highlights, as bright as the tone mapping shows the
 * surfaces that they light. X3D adds highlights to display colours, so a light gets as its
 * intensity the display colour of a white surface that it lights at a distance of {@value #NEAR} m.
 * In display colours the light of a lamp falls approximately with its distance (the square, by the
 * display's exponent), and so it does here. No light has ambient intensity. A rectangle becomes a
 * spot light that shines to its front.
 */
public final class HighlightLightWriter {
  /** Distance at which the intensity is fitted, metres. */
  private static final double NEAR = 2;

  private static final int DECIMALS = 3;

  /** Fields that get new values. */
  private static final Set<String> FITTED =
      Set.of("on", "intensity", "ambientIntensity", "attenuation", "beamWidth");

  private final ReinhardToneMapping curve;
  private final boolean photometric;
  private final double unit;

  /**
   * @param photometric whether lights fall with the square of the distance; if not, they are
   *     written as they are
   * @param unit metres per unit of length
   */
  public HighlightLightWriter(ReinhardToneMapping curve, boolean photometric, double unit) {
    this.curve = curve;
    this.photometric = photometric;
    this.unit = unit;
  }

  void append(LitFileWriter into, LightInstance light, String container) {
    into.nodes().open(light.node(), container);
    X3dWriter out = into.out();
    Optional<LightSource> lamp =
        photometric && light.light().on()
            ? new LightSourceReader(true, unit, new ProblemCollector()).read(light)
            : Optional.empty();
    if (lamp.isEmpty()) {
      into.nodes().values(light.node(), "ambientIntensity", into);
    } else {
      others(into, light.node());
      out.attribute("intensity", DecimalFormatter.rounded(intensity(lamp.get()), DECIMALS));
      if (!(lamp.get() instanceof DirectionalLightSource)) {
        out.attribute("attenuation", "0 " + DecimalFormatter.rounded(unit / NEAR, DECIMALS) + " 0");
      }
      if (light.node().type().field("beamWidth").isPresent()) {
        double beam = lamp.get() instanceof RectangleLightSource ? 0.01 : light.light().beamWidth();
        out.attribute("beamWidth", DecimalFormatter.rounded(beam, 4));
      }
    }
    out.close();
  }

  private static void others(LitFileWriter into, NodeView node) {
    for (FieldDefinition field : node.type().fields().subList(0, node.type().ownFrom())) {
      boolean said =
          !field.type().isNode()
              && field.access().initialisable()
              && !FITTED.contains(field.name())
              && !Objects.deepEquals(node.value(field.index()), field.defaultValue());
      if (said) {
        into.out().attribute(field.name(), FieldValueFormatter.of(node.value(field.index())));
      }
    }
  }

  private double intensity(LightSource lamp) {
    return Math.min(1, Photometry.display(curve.share(lux(lamp) / Math.PI)));
  }

  /** Returns the illuminance on the axis of the beam at that distance, lx. */
  private static double lux(LightSource lamp) {
    double square = NEAR * NEAR;
    if (lamp instanceof DirectionalLightSource sun) {
      return sun.lumens();
    }
    if (lamp instanceof PointLightSource point) {
      return Photometry.luminance(point.candela()) / square;
    }
    if (lamp instanceof RectangleLightSource rectangle) {
      return Photometry.luminance(rectangle.luminance()) * rectangle.area() / square;
    }
    return lamp.lumens() / Math.PI / square;
  }
}
