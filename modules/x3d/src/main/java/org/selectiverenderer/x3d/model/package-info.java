/**
 * The door by which models of other programs, such as glTF, become scenes: a model is recognised by
 * its first bytes or its name, and translated into the text of an X3D scene, which is then read as
 * any scene is. So all that reads scenes reads models.
 *
 * <p>In: the bytes of a model, and the files that it may refer to by {@code x3d.url}. Out: X3D 4.0
 * in XML, and problems. The translators themselves are found by {@link java.util.ServiceLoader},
 * since they bring libraries with native parts; the module {@code models} has them. Uses {@code
 * x3d.url}, {@code x3d.source} for its limits, and {@code base.problem}.
 */
@NullMarked
package org.selectiverenderer.x3d.model;

import org.jspecify.annotations.NullMarked;
