package org.selectiverenderer.x3d.vrml;

import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.NodeType;

/**
 * What X3D 4.0 calls the fields that VRML97 (ISO/IEC 14772-1, 6) and X3D 3.3 called otherwise.
 * Files of ClassicVRML have VRML97's names, too, so that these are read in both.
 */
final class FormerNames {
  private static final Map<String, Map<String, String>> NAMES =
      Map.of(
          "Collision", Map.of("collide", "enabled"),
          "Layer", Map.of("isPickable", "pickable"),
          "LayoutLayer", Map.of("isPickable", "pickable"),
          "LOD", Map.of("level", "children"),
          "Switch", Map.of("choice", "children"));

  private FormerNames() {}

  /** The name of a field or of its events, in X3D. */
  static String now(@Nullable NodeType type, String name) {
    Map<String, String> names = type == null ? null : NAMES.get(type.name());
    if (names == null) {
      return name;
    }
    String field = name;
    String before = "";
    String behind = "";
    if (name.startsWith("set_")) {
      before = "set_";
      field = name.substring(before.length());
    } else if (name.endsWith("_changed")) {
      behind = "_changed";
      field = name.substring(0, name.length() - behind.length());
    }
    String now = names.get(field);
    return now == null || type.field(field).isPresent() ? name : before + now + behind;
  }
}
