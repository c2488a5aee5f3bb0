package org.selectiverenderer.x3d;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;

/** A handful of node types made by hand, with the fields that tests of the runtime need. */
public final class FewNodeTypes {
  private static final Map<String, Set<String>> ANCESTORS =
      Map.of(
          "Group", Set.of("X3DGroupingNode"),
          "Transform", Set.of("X3DGroupingNode"),
          "Switch", Set.of("X3DGroupingNode"),
          "Collision", Set.of("X3DGroupingNode"),
          "Shape", Set.of("X3DShapeNode"),
          "Geometry", Set.of("X3DGeometryNode"),
          "NavigationInfo", Set.of("X3DBindableNode"));

  private final List<FieldDefinition> fields = new ArrayList<>();

  private FewNodeTypes() {}

  private FewNodeTypes with(String name, FieldType type, Object value) {
    fields.add(
        new FieldDefinition(
            fields.size(),
            name,
            type,
            FieldAccess.INPUT_OUTPUT,
            "",
            "",
            "",
            List.of(),
            List.of(),
            value));
    return this;
  }

  public static NodeType of(String name) {
    FewNodeTypes made = new FewNodeTypes();
    if (ANCESTORS.get(name).contains("X3DGroupingNode")) {
      made.with("children", FieldType.MFNode, List.of());
      made.with("visible", FieldType.SFBool, true);
    }
    switch (name) {
      case "Transform" ->
          made.with("translation", FieldType.SFVec3f, new float[3])
              .with("center", FieldType.SFVec3f, new float[3])
              .with("rotation", FieldType.SFRotation, new float[] {0, 0, 1, 0})
              .with("scale", FieldType.SFVec3f, new float[] {1, 1, 1})
              .with("scaleOrientation", FieldType.SFRotation, new float[] {0, 0, 1, 0});
      case "Switch" -> made.with("whichChoice", FieldType.SFInt32, -1);
      case "Collision" ->
          made.with("enabled", FieldType.SFBool, true).with("proxy", FieldType.SFNode, null);
      case "Shape" ->
          made.with("geometry", FieldType.SFNode, null).with("appearance", FieldType.SFNode, null);
      case "NavigationInfo" ->
          made.with("avatarSize", FieldType.MFFloat, new float[] {0.25f, 1.6f, 0.75f})
              .with("speed", FieldType.SFFloat, 1f)
              .with("type", FieldType.MFString, new String[] {"EXAMINE", "ANY"});
      default -> {
        // No fields.
      }
    }
    return new NodeType(name, "Test", 1, "children", ANCESTORS.get(name), made.fields);
  }
}
