package org.selectiverenderer.validation;

import java.util.Set;
import org.selectiverenderer.x3d.catalogue.NodeCatalogue;
import org.selectiverenderer.x3d.read.X3dFile;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.StatementNames;
import org.selectiverenderer.x3d.source.XmlDocument;

/**
 * What a {@link FileCheck} sees.
 *
 * @param document all elements and attributes with their places; {@link XmlDocument#broken()} where
 *     it ends too early
 * @param scene the nodes made of it, prototypes expanded, names and routes resolved; a node's
 *     {@code location()} is that of its element
 * @param rules ids of all rules
 */
public record FileView(
    NodeCatalogue catalogue, XmlDocument document, X3dFile scene, Set<String> rules) {
  /** Whether an element is one of X3D. */
  public boolean knows(DocumentElement element) {
    return StatementNames.is(element.name()) || catalogue.find(element.name()).isPresent();
  }
}
