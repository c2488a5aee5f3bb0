package org.selectiverenderer.x3d.read;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.files.ContentBase;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * A prototype: its interface and its body, kept for making instances (X3D 4.0, 4.4.4).
 *
 * @param environment the scope that declares it, whose prototypes its body may use
 * @param base where relative urls in its body start; null for the file that is being read
 * @param angles the unit of the angles in its body
 * @param lacking fields that somebody expects it to have and that it has not, which was told
 */
record ProtoDeclaration(
    String name,
    Map<String, Field> fields,
    DocumentElement body,
    NameScope environment,
    @Nullable ContentBase base,
    AngleUnit angles,
    Set<String> lacking)
    implements DeclaredPrototype {
  /**
   * A field of the interface.
   *
   * @param value the default, or null when the declaration gives none or gives nodes
   * @param nodes the default of an SFNode or MFNode
   */
  record Field(
      String name,
      FieldType type,
      FieldAccess access,
      @Nullable Object value,
      List<DocumentElement> nodes) {}

  ProtoDeclaration without(Set<String> missing) {
    return new ProtoDeclaration(name, fields, body, environment, base, angles, Set.copyOf(missing));
  }

  /** The field that takes or sends events under that name, by either spelling. */
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
