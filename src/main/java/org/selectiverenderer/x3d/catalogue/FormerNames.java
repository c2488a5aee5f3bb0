package org.selectiverenderer.x3d.catalogue;

import java.util.Map;
import org.jspecify.annotations.Nullable;

/**
 * What X3D 4.0 calls the fields that earlier standards called otherwise: VRML97 (ISO/IEC 14772-1,
 * 6; X3D 4.0, 10.4) and X3D 3.2 and 3.3 (35.3.1, X3DLayerNode). Files of all encodings and versions
 * have the old names, so that they are read in all.
 */
public final class FormerNames {
  private static final Map<String, Map<String, String>> NAMES =
      Map.of(
          "Collision", Map.of("collide", "enabled"),
          "Layer", Map.of("isPickable", "pickable"),
          "LayoutLayer", Map.of("isPickable", "pickable"),
          "LOD", Map.of("level", "children"),
          "Switch", Map.of("choice", "children"));

  private FormerNames() {}

  /** The name of a field or of its events, in X3D. */
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
