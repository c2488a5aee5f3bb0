package org.selectiverenderer.x3d.catalogue;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * Maps field names of earlier standards to those of X3D 4.0: VRML97 (ISO/IEC 14772-1, 6; X3D 4.0,
 * 10.4) and X3D 3.2 and 3.3 (35.3.1, X3DLayerNode). Since files of all encodings and versions use
 * the old names, they are accepted in all.
 */
public final class LegacyFieldNames {
  private static final Map<String, Map<String, String>> NAMES =
      Map.of(
          "Collision", Map.of("collide", "enabled"),
          "Layer", Map.of("isPickable", "pickable"),
          "LayoutLayer", Map.of("isPickable", "pickable"),
          "LOD", Map.of("level", "children"),
          "Switch", Map.of("choice", "children"));

  private LegacyFieldNames() {}

  /** Returns the X3D 4.0 name of a field or of its events. */
  public static String now(@Nullable NodeType type, String name) {
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
