package org.selectiverenderer.authoring.editing;

import java.util.List;
import org.selectiverenderer.x3d.source.DocumentElement;

/**
 * What the interface of a prototype says about a field of an instance, whose value is a fieldValue
 * in the instance (X3D 4.0, 4.4.4).
 *
 * @param prototype the prototype's name
 * @param info the declaration's appinfo; empty for none
 * @param declared false if the prototype is known but declares no such field
 * @param external whether the default is in the prototype's own file
 * @param nodes the nodes that an SFNode or MFNode holds; those of the declaration by default
 */
public record InterfaceField(
    String prototype,
    String info,
    boolean declared,
    boolean external,
    List<DocumentElement> nodes) {}
