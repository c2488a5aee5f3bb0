package org.selectiverenderer.validation.report;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.selectiverenderer.base.files.Sha256;
import org.selectiverenderer.validation.Finding;

/**
 * Computes fingerprints of findings, which stay the same when lines move, so that other programs
 * can distinguish old findings from new ones. A fingerprint is a hash of rule, file, node and
 * message, and of the number of equal findings before it.
 */
public final class Fingerprints {
  private static final int DIGITS = 32;

  private Fingerprints() {}

  /** Returns a fingerprint for each finding, in their order: 32 hexadecimal digits. */
  public static List<String> of(List<Finding> findings) {
    Map<String, Integer> before = new HashMap<>();
    List<String> prints = new ArrayList<>(findings.size());
    for (Finding finding : findings) {
      String text =
          String.join(
              "\n",
              finding.rule().id(),
              finding.location().file(),
              finding.node(),
              finding.message());
      int number = before.merge(text, 1, Integer::sum);
      String hash = Sha256.of((text + "\n" + number).getBytes(StandardCharsets.UTF_8));
      prints.add(hash.substring(0, DIGITS));
    }
    return prints;
  }
}
