/**
 * The examples that the program brings: the scenes, models and studies that its pages name, in the
 * same folders, but for the apartment that is lit by radiosity, which would double their size.
 *
 * <p>In: files of the jar, where the build lays them ({@code src/pom.xml}). Out: copies in a folder
 * of the user's; nothing there is ever overwritten. Uses {@code app.recent} and {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.app.examples;

import org.jspecify.annotations.NullMarked;
