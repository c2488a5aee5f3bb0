package org.selectiverenderer.formats.image;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;

class SvgWriterTest {
  private static String drawing(SvgPrecision precision) {
    SvgWriter svg = new SvgWriter(100, 50, "'A', \"B\"", "a < b", precision);
    svg.rectangle(1, 2.25, -3, 4, "#fff");
    svg.path(svg.line(List.of(new double[] {0, 1}, new double[] {2.005, 3})) + "Z", "fill", "none");
    svg.circle(1, 2, 3, "r2", 0.5, "stroke", "");
    svg.text("x & \"y\"\u0001", 5, 6, "font-size", 12);
    return svg.finish();
  }

  @Test
  void elementsComeOneALine() {
    assertThat(drawing(SvgPrecision.TENTHS))
        .isEqualTo(
            """
            <svg xmlns="http://www.w3.org/2000/svg" width="100" height="50" viewBox="0 0 100 50" font-family="'A', &quot;B&quot;">
            <title>a &lt; b</title>
            <rect x="1.0" y="2.3" width="0.0" height="4.0" fill="#fff"/>
            <path d="M0.0 1.0L2.0 3.0Z" fill="none"/>
            <circle cx="1.0" cy="2.0" r="3.0" r2="0.5"/>
            <text x="5.0" y="6.0" font-size="12">x &amp; "y"?</text>
            </svg>
            """);
    assertThat(drawing(SvgPrecision.HUNDREDTHS))
        .contains("x=\"1\" y=\"2.25\" width=\"0\"", "M0 1L2.01 3Z", "r=\"3\" r2=\"0.5\"");
  }

  @Test
  void theBytesAreThoseOfEveryLocale() {
    String before = drawing(SvgPrecision.HUNDREDTHS);
    Locale locale = Locale.getDefault();
    Locale.setDefault(Locale.forLanguageTag("fa-IR"));
    try {
      assertThat(drawing(SvgPrecision.HUNDREDTHS)).isEqualTo(before);
    } finally {
      Locale.setDefault(locale);
    }
  }
}
