package org.selectiverenderer.x3d.read;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;

/** Reads prototype declarations, whose bodies are recorded as elements to be expanded later. */
final class ProtoDeclarationReader {
  private final ReadContext reading;

  ProtoDeclarationReader(ReadContext reading) {
    this.reading = reading;
  }

  /** Reads a ProtoDeclare. */
  void declare(ElementCursor in, NameScope scope) {
    SourceLocation location = in.location();
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
    if (body == null && in.broken()) {
      return; // the file is truncated here, which is reported
    }
    if (name == null || body == null) {
      reading.error(location, "a ProtoDeclare needs a name and a ProtoBody; this one is left out");
      return;
    }
    scope.declare(
        new ProtoDeclaration(
            name, fields, body, scope, reading.base(), reading.angles(), Set.of()));
  }

  private ProtoDeclaration.@Nullable Field field(ElementCursor in) {
    SourceLocation location = in.location();
    FieldDeclaration declared = FieldDeclaration.of(in);
    if (declared == null) {
      reading.error(
          location,
          "the interface of a prototype may contain only field elements with name, type and "
              + "accessType; this "
              + in.name()
              + " is left out");
      in.skip();
      return null;
    }
    int value = in.indexOf("value");
    FieldType type = declared.type();
    Object parsed =
        value >= 0 && !type.isNode()
            ? reading.angles().radians(type, in.attributeValue(value, type))
            : null;
    List<DocumentElement> children = in.record().children();
    return new ProtoDeclaration.Field(
        declared.name(), type, declared.access(), parsed, type.isNode() ? children : List.of());
  }

  /** Reads an ExternProtoDeclare; its file is loaded when there is an instance. */
  void declareExternal(ElementCursor in, NameScope scope) {
    SourceLocation location = in.location();
    String name = in.attribute("name");
    int url = in.indexOf("url");
    Object urls = url < 0 ? null : in.attributeValue(url, FieldType.MFString);
    List<ExternProtoDeclaration.Field> fields = new ArrayList<>();
    while (in.next()) {
      SourceLocation at = in.location();
      ProtoDeclaration.Field field = field(in);
      if (field != null) {
        fields.add(
            new ExternProtoDeclaration.Field(field.name(), field.type(), field.access(), at));
      }
    }
    if (name == null) {
      reading.error(location, "an ExternProtoDeclare needs a name; this one is left out");
      return;
    }
    scope.declare(
        new ExternProtoDeclaration(
            name,
            List.copyOf(fields),
            urls == null ? List.of() : List.of((String[]) urls),
            reading.urlBase(),
            location));
  }
}
