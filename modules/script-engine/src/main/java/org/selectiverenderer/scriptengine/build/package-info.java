/**
 * Makes the metered engine in the build: reads Rhino's jar, inserts calls of the meter and writes
 * the classes beside those of this module. It is no part of the jar. In: Rhino's jar. Out: class
 * files. Uses ASM.
 */
@NullMarked
package org.selectiverenderer.scriptengine.build;

import org.jspecify.annotations.NullMarked;
