package org.selectiverenderer.lsl;

import java.util.List;

/**
 * The description of a stream (LSL: stream info).
 *
 * @param name name of the stream, for people
 * @param type content type, such as {@code EEG}, {@code MoCap} or {@code Markers} (XDF's names)
 * @param channels the channels, in the order of a sample's values
 * @param rate nominal samples per second; 0 for an irregular rate
 * @param texts whether the values are texts; if not, they are numbers
 * @param sourceId identifies the source, also after its program is restarted
 * @param host the machine that sends the stream; empty for this one
 * @param uid unique id of this instance of the stream; empty for one that is not sent yet
 */
public record StreamInfo(
    String name,
    String type,
    List<Channel> channels,
    double rate,
    boolean texts,
    String sourceId,
    String host,
    String uid) {

  /** A channel: one value of each sample. Unit and type are XDF's, and empty for none. */
  public record Channel(String label, String unit, String type) {}

  public StreamInfo {
    channels = List.copyOf(channels);
  }

  /** Returns the description of a stream that this program sends at an irregular rate. */
  public static StreamInfo sent(
      String name, String type, List<Channel> channels, boolean texts, String sourceId) {
    return new StreamInfo(name, type, channels, 0, texts, sourceId, "", "");
  }
}
