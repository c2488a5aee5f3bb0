/**
 * MPEG-1 video (ISO/IEC 11172-2), alone or in an MPEG-1 system stream (11172-1): what a browser has
 * to play as a MovieTexture (X3D 4.0, 18.4.2). No library is at hand that does it: those in pure
 * Java know later standards, and take this one amiss.
 *
 * <p>In: the bytes of a file. Out: an {@link org.selectiverenderer.runtime.movie.mpeg.MpegVideo},
 * which knows its pictures, and of that an {@link
 * org.selectiverenderer.runtime.movie.mpeg.MpegDecoder}, which makes any of them. {@link
 * org.selectiverenderer.runtime.movie.mpeg.SystemStream} takes the video out of a stream, {@link
 * org.selectiverenderer.runtime.movie.mpeg.Slice} reads macroblocks by the tables of {@link
 * org.selectiverenderer.runtime.movie.mpeg.MpegCodes}, {@link
 * org.selectiverenderer.runtime.movie.mpeg.SampleBlock} their coefficients; {@link
 * org.selectiverenderer.runtime.movie.mpeg.Planes} are the picture. Uses nothing of this program.
 */
@NullMarked
package org.selectiverenderer.runtime.movie.mpeg;

import org.jspecify.annotations.NullMarked;
