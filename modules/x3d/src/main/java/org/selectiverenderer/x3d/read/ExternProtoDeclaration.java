package org.selectiverenderer.x3d.read;

import java.util.List;
import org.selectiverenderer.base.problem.SourceLocation;
import org.selectiverenderer.x3d.catalogue.AccessType;
import org.selectiverenderer.x3d.field.FieldType;
import org.selectiverenderer.x3d.url.BaseUrl;

/**
 * An EXTERNPROTO declaration (X3D 4.0, 4.4.5), whose file is loaded when there is an instance.
 *
 * @param fields the fields that this file expects
 * @param base the base of its relative urls
 */
record ExternProtoDeclaration(
    String name, List<Field> fields, List<String> urls, BaseUrl base, SourceLocation location)
    implements DeclaredPrototype {
  /** An expected field. */
  record Field(String name, FieldType type, AccessType access, SourceLocation location) {}
}
