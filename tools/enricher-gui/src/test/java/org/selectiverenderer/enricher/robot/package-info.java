/** Drives real windows as an author's hands do, and takes pictures of them for looking at. */
@NullMarked
package org.selectiverenderer.enricher.robot;

import org.jspecify.annotations.NullMarked;
