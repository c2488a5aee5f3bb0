package org.selectiverenderer.enricher.cost;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** Limits as people write them. */
class StatesModelTest {
  @Test
  void numbersAreReadAsPeopleWriteThem() {
    assertThat(StatesModel.number("170 000")).contains(170000L);
    assertThat(StatesModel.number("170,000")).contains(170000L);
    assertThat(StatesModel.number("170.000")).contains(170000L);
    assertThat(StatesModel.number("many")).isEmpty();
    assertThat(StatesModel.number("-5")).isEmpty();
    assertThat(StatesModel.number("99999999999999999999")).isEmpty();
  }
}
