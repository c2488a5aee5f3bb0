package org.selectiverenderer.statistics.report;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.math.BigDecimal;
import java.math.MathContext;

/** Writes the numbers of JSON reports: 10 significant digits, null for NaN and infinity. */
final class JsonNumbers {
  private static final MathContext DIGITS = new MathContext(10);

  private JsonNumbers() {}

  static void put(ObjectNode node, String key, double value) {
    if (!Double.isFinite(value)) {
      node.putNull(key);
    } else if (value == Math.rint(value) && Math.abs(value) < 1e9) {
      node.put(key, (long) value);
    } else {
      node.put(key, new BigDecimal(value).round(DIGITS).doubleValue());
    }
  }
}
