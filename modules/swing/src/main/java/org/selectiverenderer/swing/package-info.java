/**
 * What the Swing windows of the program share, and what takes AWT's images. It uses nothing of
 * ours.
 */
@NullMarked
package org.selectiverenderer.swing;

import org.jspecify.annotations.NullMarked;
