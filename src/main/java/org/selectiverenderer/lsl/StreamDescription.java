package org.selectiverenderer.lsl;

import java.util.List;

/**
 * What a stream is.
 *
 * @param name by which people know it
 * @param type its content, such as {@code EEG}, {@code MoCap} or {@code Markers} (XDF's names)
 * @param channels in the order of a sample's values
 * @param rate samples per second; 0 for an irregular one
 * @param texts whether values are texts; else they are numbers
 * @param sourceId by which a program that was started anew is known again
 * @param host the machine that sends it; empty for this one
 * @param uid of this very stream; empty for one that is not sent yet
 */
public record StreamDescription(
    String name,
    String type,
    List<Channel> channels,
    double rate,
    boolean texts,
    String sourceId,
    String host,
    String uid) {

  /** A value of each sample; unit and type as XDF has them, empty where there are none. */
  public record Channel(String label, String unit, String type) {}

  public StreamDescription {
    channels = List.copyOf(channels);
  }

  /** One that is sent from here, at an irregular rate. */
  public static StreamDescription sent(
      String name, String type, List<Channel> channels, boolean texts, String sourceId) {
    return new StreamDescription(name, type, channels, 0, texts, sourceId, "", "");
  }
}
