package org.selectiverenderer.x3d.read;

import java.util.List;
import org.selectiverenderer.base.problem.Location;
import org.selectiverenderer.x3d.catalogue.FieldAccess;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.files.ContentBase;

/**
 * A prototype of another file (X3D 4.0, 4.4.5), which is read when there is an instance.
 *
 * @param fields that this file expects it to have
 * @param base where its relative urls start
 */
record ExternDeclaration(
    String name, List<Field> fields, List<String> urls, ContentBase base, Location location)
    implements DeclaredPrototype {
  /** A field as this file expects it. */
  record Field(String name, FieldType type, FieldAccess access, Location location) {}
}
