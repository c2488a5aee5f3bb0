package org.selectiverenderer.study.session;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import org.junit.jupiter.api.Test;

/** Ids that are easily typed for each other. */
class ParticipantIdsTest extends TwoRoomStudyFixture {
  @Test
  void capitalsLeadingZerosAndAPrefixMakeNoOtherPerson() {
    assertThat(ParticipantIds.alike("1", "001")).isTrue();
    assertThat(ParticipantIds.alike("P01", "p01")).isTrue();
    assertThat(ParticipantIds.alike("P01", "1")).isTrue();
    assertThat(ParticipantIds.alike("anna", "Anna")).isTrue();
    assertThat(ParticipantIds.alike("A01B2", "a1b02")).isTrue();
    assertThat(ParticipantIds.alike("1", "10")).isFalse();
    assertThat(ParticipantIds.alike("100", "1")).isFalse();
    assertThat(ParticipantIds.alike("A01", "B01")).isFalse();
    assertThat(ParticipantIds.alike("01a", "01b")).isFalse();
    assertThat(ParticipantIds.alike("anna", "anne")).isFalse();
    assertThat(ParticipantIds.alike("0", "00")).isTrue();
    assertThat(ParticipantIds.alike("12345678901234567890", "012345678901234567890")).isTrue();
  }

  @Test
  void theNextFreeNumberLooksLikeNobody() throws IOException {
    begin("P01").close();
    begin("2").close();
    ParticipantIds ids = ParticipantIds.of(material().study());
    assertThat(ids.next()).isEqualTo("003");
    assertThat(ids.alike("001")).contains("P01");
    assertThat(ids.alike("P01")).isEmpty();
    assertThat(ids.sameFolder("p01")).contains("P01");
    assertThat(ids.sameFolder("P01")).isEmpty();
  }
}
