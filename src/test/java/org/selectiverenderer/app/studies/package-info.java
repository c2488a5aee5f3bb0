/** The study window's knowledge of studies, without a window. */
@NullMarked
package org.selectiverenderer.app.studies;

import org.jspecify.annotations.NullMarked;
