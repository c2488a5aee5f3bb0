/** The study window, driven by mouse and keys on a real screen. */
@NullMarked
package org.selectiverenderer.app.studies.window;

import org.jspecify.annotations.NullMarked;
