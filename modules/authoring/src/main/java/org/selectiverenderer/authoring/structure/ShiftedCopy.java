package org.selectiverenderer.authoring.structure;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.joml.Vector3dc;
import org.selectiverenderer.authoring.SceneDocument;
import org.selectiverenderer.authoring.SourceFormatter;
import org.selectiverenderer.base.decimal.DecimalFormatter;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.catalogue.NodeType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * The text of a copy that lies beside its original: what has a position gets another one; what is
 * drawn without having one is wrapped in a Transform; all else is not moved.
 */
final class ShiftedCopy {
  private static final int DECIMALS = 4;

  /** The fields that are a position in the coordinates of the parent (X3D 4.0). */
  private static final Map<String, String> POSITIONS =
      Map.of(
          "Transform", "translation",
          "HAnimHumanoid", "translation",
          "PointLight", "location",
          "SpotLight", "location",
          "Viewpoint", "position",
          "OrthoViewpoint", "position",
          "ProximitySensor", "center",
          "VisibilitySensor", "center",
          "TransformSensor", "center",
          "Sound", "location");

  private static final List<String> DRAWN =
      List.of("X3DShapeNode", "X3DGroupingNode", "Inline", "LOD");

  private final SceneDocument document;
  private final Containment containment;
  private final NodeCatalogue catalogue;

  ShiftedCopy(SceneDocument document, Containment containment, NodeCatalogue catalogue) {
    this.document = document;
    this.containment = containment;
    this.catalogue = catalogue;
  }

  /** Returns the lines of a shifted copy. */
  List<String> lines(Pieces pieces, DocumentElement node, Vector3dc shift) {
    Optional<String> position =
        Optional.ofNullable(POSITIONS.get(node.name())).filter(field -> node.use().isEmpty());
    if (position.isPresent()) {
      pieces.change(
          document.layout().attribute(node, position.get(), moved(node, position.get(), shift)));
      return pieces.lines(node);
    }
    if (!wrapped(node)) {
      return pieces.lines(node);
    }
    char quote = document.layout().quote(node);
    List<String> lines = new ArrayList<>();
    lines.add("<Transform" + SourceFormatter.written("translation", text(shift), quote) + ">");
    String step = document.layout().step(node);
    pieces.lines(node).forEach(line -> lines.add(step + line));
    lines.add("</Transform>");
    return lines;
  }

  private boolean wrapped(DocumentElement node) {
    Optional<NodeType> type = containment.type(node);
    boolean drawn =
        type.map(found -> DRAWN.stream().anyMatch(found::is))
            .orElse(node.name().equals("ProtoInstance"));
    boolean child =
        node.text("containerField").filter(field -> !field.equals(Containment.CHILDREN)).isEmpty();
    boolean choice = node.parent().filter(parent -> parent.name().equals("Switch")).isPresent();
    return drawn && child && !choice && catalogue.find("Transform").isPresent();
  }

  private static String moved(DocumentElement node, String field, Vector3dc shift) {
    double[] old = {0, 0, "position".equals(field) ? 10 : 0}; // the default of viewpoints
    String[] written =
        node.text(field).map(text -> text.strip().split("[\\s,]+")).orElse(new String[0]);
    for (int i = 0; i < 3 && written.length == 3; i++) {
      try {
        old[i] = Double.parseDouble(written[i]);
      } catch (NumberFormatException e) {
        old[i] = 0; // a fault that the validator reports
      }
    }
    return DecimalFormatter.rounded(old[0] + shift.x(), DECIMALS)
        + " "
        + DecimalFormatter.rounded(old[1] + shift.y(), DECIMALS)
        + " "
        + DecimalFormatter.rounded(old[2] + shift.z(), DECIMALS);
  }

  private static String text(Vector3dc of) {
    return DecimalFormatter.rounded(of.x(), DECIMALS)
        + " "
        + DecimalFormatter.rounded(of.y(), DECIMALS)
        + " "
        + DecimalFormatter.rounded(of.z(), DECIMALS);
  }
}
