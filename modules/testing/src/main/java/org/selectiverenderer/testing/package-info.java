/**
 * What tests of several packages share.
 *
 * <p>{@link org.selectiverenderer.testing.RequiresDisplay} marks tests that draw. May use JOGL and
 * JUnit, nothing of the program.
 */
@NullMarked
package org.selectiverenderer.testing;

import org.jspecify.annotations.NullMarked;
