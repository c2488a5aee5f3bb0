package org.selectiverenderer.validation;

import java.nio.charset.StandardCharsets;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;

/**
 * Names of findings that stay the same when lines move, so that other programs can tell old
 * findings from new ones: of rule, file, node and message, and of the number of equal ones before
 * it.
 */
public final class Fingerprints {
  private static final int BYTES = 16;

  private Fingerprints() {}

  /** One for each finding, in their order: 32 hexadecimal digits. */
  public static List<String> of(List<Finding> findings) {
    MessageDigest digest = sha256();
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
      byte[] hash = digest.digest((text + "\n" + number).getBytes(StandardCharsets.UTF_8));
      prints.add(HexFormat.of().formatHex(hash, 0, BYTES));
    }
    return prints;
  }

  private static MessageDigest sha256() {
    try {
      return MessageDigest.getInstance("SHA-256");
    } catch (NoSuchAlgorithmException e) {
      throw new IllegalStateException("every Java has SHA-256", e);
    }
  }
}
