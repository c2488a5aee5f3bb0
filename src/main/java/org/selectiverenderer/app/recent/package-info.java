/**
 * The lists of studies and scenes that were opened lately, in the folder of the user's settings.
 *
 * <p>In and out: files of one path a line. Uses {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.app.recent;

import org.jspecify.annotations.NullMarked;
