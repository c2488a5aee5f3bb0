/**
 * Long work in parts: on all processors, with progress, until it is cancelled. Uses nothing else of
 * ours.
 */
@NullMarked
package org.selectiverenderer.radiosity.work;

import org.jspecify.annotations.NullMarked;
