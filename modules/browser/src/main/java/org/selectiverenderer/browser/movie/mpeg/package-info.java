/**
 * MPEG-1 video (ISO/IEC 11172-2), alone or in an MPEG-1 system stream (11172-1): the format that a
 * browser must play as a MovieTexture (X3D 4.0, 18.4.2). No suitable library exists: those in pure
 * Java decode later standards, but not this one correctly.
 *
 * <p>In: the bytes of a file. Out: an {@link org.selectiverenderer.browser.movie.mpeg.MpegVideo},
 * which knows its pictures, and from it an {@link
 * org.selectiverenderer.browser.movie.mpeg.MpegDecoder}, which decodes any of them. {@link
 * org.selectiverenderer.browser.movie.mpeg.SystemStreamDemuxer} extracts the video from a stream,
 * {@link org.selectiverenderer.browser.movie.mpeg.SliceDecoder} decodes macroblocks by the tables
 * of {@link org.selectiverenderer.browser.movie.mpeg.MpegVlcTables}, {@link
 * org.selectiverenderer.browser.movie.mpeg.DctBlock} their coefficients; {@link
 * org.selectiverenderer.browser.movie.mpeg.YCbCrPicture} are the decoded picture. Uses no other
 * package of this program.
 */
@NullMarked
package org.selectiverenderer.browser.movie.mpeg;

import org.jspecify.annotations.NullMarked;
