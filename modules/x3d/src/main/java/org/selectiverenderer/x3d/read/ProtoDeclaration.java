package org.selectiverenderer.x3d.read;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.url.BaseUrl;

/**
 * A prototype declaration with its interface and its recorded body (X3D 4.0, 4.4.4).
 *
 * @param environment the scope of the declaration, whose prototypes the body may use
 * @param base the base of relative urls in its body; null for the file that is being read
 * @param angles the unit of the angles in its body
 * @param lacking fields missing in the interface that an EXTERNPROTO expects; already reported
 */
record ProtoDeclaration(
    String name,
    Map<String, Field> fields,
    DocumentElement body,
    NameScope environment,
    @Nullable BaseUrl base,
    AngleUnit angles,
    Set<String> lacking)
    implements DeclaredPrototype {
  /**
   * A field of the interface.
   *
   * @param value the default; null if there is none or it consists of nodes
   * @param nodes the default of an SFNode or MFNode
   */
  record Field(
      String name,
      FieldType type,
      AccessType access,
      @Nullable Object value,
      List<DocumentElement> nodes) {}

  ProtoDeclaration without(Set<String> missing) {
    return new ProtoDeclaration(name, fields, body, environment, base, angles, Set.copyOf(missing));
  }

  /**
   * Returns the field that receives or sends events of a name, with or without prefix or suffix.
   */
  @Nullable Field event(String name, boolean input) {
    Field field = fields.get(name);
    if (field == null && input && name.startsWith("set_")) {
      field = fields.get(name.substring("set_".length()));
    } else if (field == null && !input && name.endsWith("_changed")) {
      field = fields.get(name.substring(0, name.length() - "_changed".length()));
    }
    if (field == null) {
      return null;
    }
    return (input ? field.access().acceptsEvents() : field.access().sendsEvents()) ? field : null;
  }
}
