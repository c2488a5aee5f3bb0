package org.selectiverenderer.x3d.read;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * Reads declarations of prototypes; their bodies are kept as elements until there is an instance.
 */
final class ProtoDeclarationReader {
  private final ReadState reading;

  ProtoDeclarationReader(ReadState reading) {
    this.reading = reading;
  }

  /** Reads a ProtoDeclare. */
  void declare(ElementCursor in, NameScope scope) {
    Location location = in.location();
    String name = in.attribute("name");
    Map<String, ProtoDeclaration.Field> fields = new LinkedHashMap<>();
    DocumentElement body = null;
    while (in.next()) {
      switch (in.name()) {
        case "ProtoInterface" -> {
          while (in.next()) {
            ProtoDeclaration.Field field = field(in);
            if (field != null) {
              fields.put(field.name(), field);
            }
          }
        }
        case "ProtoBody" -> body = in.record();
        default -> {
          reading.error(
              in.location(),
              "a ProtoDeclare may contain only a ProtoInterface and a ProtoBody; "
                  + in.name()
                  + " is left out");
          in.skip();
        }
      }
    }
    if (name == null || body == null) {
      reading.error(location, "a ProtoDeclare needs a name and a ProtoBody; this one is left out");
      return;
    }
    scope.declare(new ProtoDeclaration(name, fields, body, scope));
  }

  private ProtoDeclaration.@Nullable Field field(ElementCursor in) {
    Location location = in.location();
    FieldElement declared = FieldElement.of(in);
    if (declared == null) {
      reading.error(
          location,
          "a ProtoInterface may contain only field elements with name, type and "
              + "accessType; this "
              + in.name()
              + " is left out");
      in.skip();
      return null;
    }
    int value = in.indexOf("value");
    FieldType type = declared.type();
    Object parsed = value >= 0 && !type.isNode() ? in.attributeValue(value, type) : null;
    List<DocumentElement> children = in.record().children();
    return new ProtoDeclaration.Field(
        declared.name(), type, declared.access(), parsed, type.isNode() ? children : List.of());
  }

  /** Reads an ExternProtoDeclare, which is told and left out with its instances. */
  void declareExternal(ElementCursor in, NameScope scope) {
    String name = in.attribute("name");
    reading.warning(
        in.location(),
        "prototypes of other files are not loaded; "
            + (name == null ? "this one" : name)
            + " is left out with all its instances");
    if (name != null) {
      scope.declareExternal(name);
    }
    in.skip();
  }
}
