package org.selectiverenderer.validation;

import java.util.Set;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.StatementNames;
import org.selectiverenderer.x3d.source.XmlDocument;

/**
 * The context of a {@link FileCheck}: the parsed file.
 *
 * @param document all elements and attributes with their locations; {@link XmlDocument#broken()} if
 *     it ends too early
 * @param scene the nodes of the document, with prototypes expanded and names and routes resolved; a
 *     node's {@code location()} is that of its element
 * @param rules ids of all rules
 */
public record FileContext(
    NodeCatalogue catalogue, XmlDocument document, X3dFile scene, Set<String> rules) {
  /** Returns whether an element is defined by X3D. */
  public boolean knows(DocumentElement element) {
    return StatementNames.is(element.name()) || catalogue.find(element.name()).isPresent();
  }
}
