package org.selectiverenderer.browser.instance;

import java.util.Optional;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.browser.scene.Node;

/** Reads LineProperties, PointProperties and FillProperties of an Appearance (X3D 4.0, 12.4). */
final class DrawPropertiesReader {
  private DrawPropertiesReader() {}

  static DrawProperties read(@Nullable Node appearance) {
    if (appearance == null || !appearance.type().name().equals("Appearance")) {
      return DrawProperties.PLAIN;
    }
    DrawProperties.@Nullable Line line =
        part(appearance, "lineProperties", "LineProperties")
            .filter(node -> node.bool("applied"))
            .map(DrawPropertiesReader::line)
            .orElse(null);
    DrawProperties.@Nullable Dot dot =
        part(appearance, "pointProperties", "PointProperties")
            .map(DrawPropertiesReader::dot)
            .orElse(null);
    DrawProperties.@Nullable Fill fill =
        part(appearance, "fillProperties", "FillProperties")
            .map(DrawPropertiesReader::fill)
            .orElse(null);
    return line == null && dot == null && fill == null
        ? DrawProperties.PLAIN
        : new DrawProperties(line, dot, fill);
  }

  private static Optional<Node> part(Node appearance, String field, String type) {
    return appearance.type().field(field).isEmpty()
        ? Optional.empty()
        : Optional.ofNullable(appearance.node(field))
            .filter(node -> node.type().name().equals(type));
  }

  private static DrawProperties.Line line(Node node) {
    return new DrawProperties.Line(
        (Integer) node.value(node.type().indexOf("linetype")),
        Math.max(1, node.number("linewidthScaleFactor")));
  }

  private static DrawProperties.Dot dot(Node node) {
    float[] attenuation = node.floats("attenuation");
    float least = node.number("pointSizeMinValue");
    return new DrawProperties.Dot(
        node.number("pointSizeScaleFactor"),
        least,
        Math.max(least, node.number("pointSizeMaxValue")),
        attenuation[0],
        attenuation[1],
        attenuation[2]);
  }

  private static DrawProperties.Fill fill(Node node) {
    float[] color = node.floats("hatchColor");
    return new DrawProperties.Fill(
        node.bool("filled"),
        node.bool("hatched"),
        (Integer) node.value(node.type().indexOf("hatchStyle")),
        color[0],
        color[1],
        color[2]);
  }
}
