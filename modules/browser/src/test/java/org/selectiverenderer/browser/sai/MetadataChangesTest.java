package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.selectiverenderer.sai.InlineSceneAccess.Registration;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.MFString;
import org.web3d.x3d.sai.SFNode;
import org.web3d.x3d.sai.SFString;
import org.web3d.x3d.sai.X3DNode;

class MetadataChangesTest {
  private final SaiFixture sai =
      SaiFixture.showing(
          """
          <Switch DEF='S'>
            <MetadataSet DEF='All' name='all' containerField='metadata'>
              <MetadataSet DEF='Part' name='part' containerField='value'>
                <MetadataString DEF='Text' name='text' value='"a"' containerField='value'/>
              </MetadataSet>
              <MetadataSet DEF='More' name='more' containerField='metadata'>
                <MetadataString DEF='Note' name='note' value='"b"' containerField='value'/>
              </MetadataSet>
            </MetadataSet>
          </Switch>
          """);
  private final List<Double> told = new ArrayList<>();
  private Registration registration =
      sai.browser.watchMetadata(sai.node("S"), told::add).orElseThrow();

  @AfterEach
  void close() {
    sai.close();
  }

  private int after(Runnable change) {
    told.clear();
    change.run();
    sai.step();
    return told.size();
  }

  private void text(String node, String field, String value) {
    ((SFString) sai.node(node).getField(field)).setValue(value);
  }

  private void value(String node) {
    ((MFString) sai.node(node).getField("value")).append("more");
  }

  @Test
  void valuesAndNamesAtEveryDepthAreTold() {
    assertThat(after(() -> value("Text"))).isOne();
    assertThat(after(() -> value("Note"))).isOne();
    assertThat(after(() -> text("Text", "name", "other"))).isOne();
    assertThat(after(() -> text("Note", "name", "other"))).isOne();
    assertThat(after(() -> text("More", "name", "other"))).isOne();
    assertThat(after(() -> ((MFNode) sai.node("All").getField("value")).clear())).isOne();
  }

  @Test
  void whatHasNoMeaningIsNotTold() {
    assertThat(after(() -> text("All", "name", "other"))).isZero();
    assertThat(after(() -> text("Part", "name", "other"))).isZero();
    assertThat(after(() -> text("Text", "reference", "other"))).isZero();
    assertThat(
            after(() -> ((MFNode) sai.node("S").getField("addChildren")).append(sai.make("Group"))))
        .isZero();
  }

  @Test
  void otherMetadataIsTold() {
    assertThat(after(() -> metadata("All", null))).isOne();
    assertThat(after(() -> metadata("S", sai.make("MetadataString")))).isOne();
    registration.close();
    registration = sai.browser.watchMetadata(sai.node("S"), told::add).orElseThrow();
    assertThat(after(() -> value("Text"))).isZero();
    assertThat(after(() -> metadata("S", null))).isOne();
  }

  private void metadata(String node, X3DNode value) {
    ((SFNode) sai.node(node).getField("metadata")).setValue(value);
  }

  @Test
  void aClosedRegistrationTellsNothing() {
    registration.close();
    registration.close();
    assertThat(after(() -> value("Text"))).isZero();
  }
}
