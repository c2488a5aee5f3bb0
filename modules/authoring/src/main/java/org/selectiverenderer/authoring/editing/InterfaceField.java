package org.selectiverenderer.authoring.editing;

import java.util.List;
import java.util.Optional;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * What the interface of a prototype says about a field of an instance, whose value is a fieldValue
 * in the instance (X3D 4.0, 4.4.4).
 *
 * @param prototype the prototype's name
 * @param info the declaration's appinfo; empty for none
 * @param refused why an instance cannot give a value, as a sentence: the prototype is known but
 *     does not declare such a field, or not one with a value; empty if it can
 * @param external whether the default is in the prototype's own file
 * @param nodes the nodes that an SFNode or MFNode holds; those of the declaration by default
 */
public record InterfaceField(
    String prototype,
    String info,
    Optional<String> refused,
    boolean external,
    List<DocumentElement> nodes) {}
