package org.selectiverenderer.browser.script;

import java.util.LinkedHashMap;
import java.util.Map;
import org.mozilla.javascript.Context;
import org.mozilla.javascript.Scriptable;
import org.mozilla.javascript.ScriptableObject;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.field.FieldType;

/**
 * The object {@code X3DConstants} of scripts (ISO/IEC 19777-1, 7.5). Scripts only compare these
 * numbers with each other; a field type's is its ordinal in {@link FieldType}, an access type's a
 * power of two.
 */
final class X3dConstants {
  private static final Map<AccessType, String> ACCESS =
      new LinkedHashMap<>(
          Map.of(
              AccessType.INITIALIZE_ONLY, "initializeOnly",
              AccessType.INPUT_ONLY, "inputOnly",
              AccessType.OUTPUT_ONLY, "outputOnly",
              AccessType.INPUT_OUTPUT, "inputOutput"));

  private X3dConstants() {}

  static int of(FieldType type) {
    return type.ordinal();
  }

  static int of(AccessType access) {
    return 1 << access.ordinal();
  }

  static Scriptable of(Context context, Scriptable scope) {
    ScriptableObject constants = (ScriptableObject) context.newObject(scope);
    for (FieldType type : FieldType.values()) {
      constants.defineProperty(type.name(), of(type), ScriptableObject.READONLY);
    }
    ACCESS.forEach(
        (access, name) -> constants.defineProperty(name, of(access), ScriptableObject.READONLY));
    String[] states = {
      "INITIALIZED_EVENT", "SHUTDOWN_EVENT", "CONNECTION_ERROR", "INITIALIZED_ERROR"
    };
    for (int i = 0; i < states.length; i++) {
      constants.defineProperty(states[i], i, ScriptableObject.READONLY);
    }
    return constants;
  }
}
