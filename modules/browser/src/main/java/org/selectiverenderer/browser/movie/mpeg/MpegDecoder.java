package org.selectiverenderer.browser.movie.mpeg;

import org.jspecify.annotations.Nullable;

/**
 * Decodes the frames of an MPEG-1 video. Decoding in order is fast; for a random frame all its
 * reference frames must be decoded. Damaged data give visible artefacts. Belongs to one thread at a
 * time.
 */
public final class MpegDecoder {
  private final MpegVideo video;
  private final MpegVlcTables codes = MpegVlcTables.load();
  private final DctBlock block = new DctBlock(codes.coefficient());
  private final int across;
  private final int down;

  /** The last two reference pictures, the older one first. */
  private @Nullable YCbCrPicture before;

  private @Nullable YCbCrPicture after;
  private @Nullable YCbCrPicture between;
  private int beforeIs = -1;
  private int afterIs = -1;
  private int betweenIs = -1;

  /** The index of the next picture to be decoded, in coding order. */
  private int next;

  MpegDecoder(MpegVideo video) {
    this.video = video;
    across = (video.width() + 15) / 16;
    down = (video.height() + 15) / 16;
  }

  /**
   * Decodes a picture.
   *
   * @param picture the index in display order, from 0 to below {@link MpegVideo#pictures()}
   * @return four bytes r, g, b, a per pixel; the first row is the lowest
   */
  public byte[] picture(int picture) {
    int code = video.coded(picture);
    if (made(code) == null) {
      int key = video.keyOf(code);
      if (next > code || next < key) {
        next = key;
        beforeIs = -1;
        afterIs = -1;
      }
      for (; next <= code; next++) {
        if (video.type(next) != MpegVideo.BETWEEN || next == code) {
          decode(next);
        }
      }
    }
    YCbCrPicture made = made(code);
    return (made == null ? new YCbCrPicture(across, down) : made)
        .rgba(video.width(), video.height());
  }

  private @Nullable YCbCrPicture made(int code) {
    return code == beforeIs ? before : code == afterIs ? after : code == betweenIs ? between : null;
  }

  private void decode(int code) {
    YCbCrPicture target;
    YCbCrPicture forward;
    if (video.type(code) == MpegVideo.BETWEEN) {
      target = between == null ? new YCbCrPicture(across, down) : between;
      between = target;
      betweenIs = code;
      forward = before;
    } else {
      target = before == null ? new YCbCrPicture(across, down) : before;
      before = after;
      beforeIs = afterIs;
      after = target;
      afterIs = code;
      forward = before;
    }
    // Without a reference picture, as in damaged videos, macroblocks that are not coded keep their
    // old pixels.
    YCbCrPicture from = forward == null ? target : forward;
    YCbCrPicture to = after == null ? from : after;
    slices(code, target, from, to);
  }

  /** Returns whether a picture, by its index in coding order, is complete. */
  boolean complete(int code) {
    YCbCrPicture any = new YCbCrPicture(across, down);
    return slices(code, any, any, any);
  }

  /** Decodes a picture's slices; returns whether the last one is complete. */
  private boolean slices(
      int code, YCbCrPicture target, YCbCrPicture forward, YCbCrPicture backward) {
    int start = video.start(code);
    int end = video.end(code);
    BitReader header = new BitReader(video.data, start + 4, end);
    header.skip(10 + 3 + 16);
    int type = video.type(code);
    SliceDecoder.Vectors ahead =
        type == MpegVideo.WHOLE ? SliceDecoder.Vectors.NONE : vectors(header);
    SliceDecoder.Vectors back =
        type == MpegVideo.BETWEEN ? vectors(header) : SliceDecoder.Vectors.NONE;
    SliceDecoder slice =
        new SliceDecoder(
            codes,
            block,
            new SliceDecoder.Weights(video.intraWeights, video.weights),
            type,
            new SliceDecoder.Pictures(target, forward, backward, across, down),
            ahead,
            back);
    int at = MpegVideo.next(video.data, start + 4);
    while (at < end) {
      int which = SystemStreamDemuxer.startCode(video.data, at);
      int behind = Math.min(end, MpegVideo.next(video.data, at + 4));
      if (which > MpegVideo.PICTURE && which <= MpegVideo.LAST_SLICE) {
        slice.read(new BitReader(video.data, at + 4, behind), which - 1);
      }
      at = behind;
    }
    return slice.complete();
  }

  private static SliceDecoder.Vectors vectors(BitReader header) {
    boolean wholePixels = header.bit();
    return new SliceDecoder.Vectors(wholePixels, Math.max(0, header.read(3) - 1));
  }
}
