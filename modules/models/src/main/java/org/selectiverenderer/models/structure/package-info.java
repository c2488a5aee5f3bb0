/**
 * Checks of a model file's structure, before a native library reads it: what it announces must fit
 * into it, and must not multiply without bound.
 *
 * <p>In: a file of another program. Out: nothing, or why it is not read. Uses Jackson.
 */
@NullMarked
package org.selectiverenderer.models.structure;

import org.jspecify.annotations.NullMarked;
