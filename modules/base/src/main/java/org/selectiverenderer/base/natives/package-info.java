/**
 * Unpacks the native parts of libraries where no other user can have put something in their place.
 *
 * <p>Libraries left alone unpack into the machine's folder of temporary files, under names that
 * anybody can guess. Here they are unpacked into a folder of the user's own, compared with what the
 * class path has each time, and named to the libraries by their own settings before their classes
 * load. The packages that call a native library do that, by {@link
 * org.selectiverenderer.base.natives.NativeLibraryFolder}; what several need for LWJGL is {@link
 * org.selectiverenderer.base.natives.LwjglLibraries}.
 *
 * <p>In: names of resources. Out: a folder, system properties, or an {@code UncheckedIOException}
 * with one line. Uses {@code base.files}.
 */
@NullMarked
package org.selectiverenderer.base.natives;

import org.jspecify.annotations.NullMarked;
