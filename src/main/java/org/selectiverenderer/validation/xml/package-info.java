/**
 * Rules of the file and its XML, SR0xx: what is to be known before a file says anything about a
 * scene. In: {@code FileView}. Uses {@code validation} and {@code x3d}.
 */
@NullMarked
package org.selectiverenderer.validation.xml;

import org.jspecify.annotations.NullMarked;
