package org.selectiverenderer.runtime.movie.mpeg;

import org.jspecify.annotations.Nullable;

/**
 * Decodes the frames of an MPEG-1 video. Decoding in order is fast; for a random frame all its
 * reference frames must be decoded. Damaged data give visible artefacts. Belongs to one thread at a
 * time.
 */
public final class MpegDecoder {
  private final MpegVideo video;
  private final MpegCodes codes = MpegCodes.load();
  private final SampleBlock block = new SampleBlock(codes.coefficient());
  private final int across;
  private final int down;

  /** The last two reference pictures, the older one first. */
  private @Nullable Planes before;

  private @Nullable Planes after;
  private @Nullable Planes between;
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
    Planes made = made(code);
    return (made == null ? new Planes(across, down) : made).rgba(video.width(), video.height());
  }

  private @Nullable Planes made(int code) {
    return code == beforeIs ? before : code == afterIs ? after : code == betweenIs ? between : null;
  }

  private void decode(int code) {
    Planes target;
    Planes forward;
    if (video.type(code) == MpegVideo.BETWEEN) {
      target = between == null ? new Planes(across, down) : between;
      between = target;
      betweenIs = code;
      forward = before;
    } else {
      target = before == null ? new Planes(across, down) : before;
      before = after;
      beforeIs = afterIs;
      after = target;
      afterIs = code;
      forward = before;
    }
    // Without a reference picture, as in damaged videos, macroblocks that are not coded keep their
    // old pixels.
    Planes from = forward == null ? target : forward;
    Planes to = after == null ? from : after;
    slices(code, target, from, to);
  }

  /** Returns whether a picture, by its index in coding order, is complete. */
  boolean complete(int code) {
    Planes any = new Planes(across, down);
    return slices(code, any, any, any);
  }

  /** Decodes a picture's slices; returns whether the last one is complete. */
  private boolean slices(int code, Planes target, Planes forward, Planes backward) {
    int start = video.start(code);
    int end = video.end(code);
    BitReader header = new BitReader(video.data, start + 4, end);
    header.skip(10 + 3 + 16);
    int type = video.type(code);
    Slice.Vectors ahead = type == MpegVideo.WHOLE ? Slice.Vectors.NONE : vectors(header);
    Slice.Vectors back = type == MpegVideo.BETWEEN ? vectors(header) : Slice.Vectors.NONE;
    Slice slice =
        new Slice(
            codes,
            block,
            new Slice.Weights(video.intraWeights, video.weights),
            type,
            new Slice.Pictures(target, forward, backward, across, down),
            ahead,
            back);
    int at = MpegVideo.next(video.data, start + 4);
    while (at < end) {
      int which = SystemStream.startCode(video.data, at);
      int behind = Math.min(end, MpegVideo.next(video.data, at + 4));
      if (which > MpegVideo.PICTURE && which <= MpegVideo.LAST_SLICE) {
        slice.read(new BitReader(video.data, at + 4, behind), which - 1);
      }
      at = behind;
    }
    return slice.complete();
  }

  private static Slice.Vectors vectors(BitReader header) {
    boolean wholePixels = header.bit();
    return new Slice.Vectors(wholePixels, Math.max(0, header.read(3) - 1));
  }
}
