package org.selectiverenderer.enricher.form;

import static org.assertj.core.api.Assertions.assertThat;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import javax.swing.AbstractButton;
import javax.swing.JCheckBox;
import javax.swing.JComponent;
import javax.swing.JLabel;
import javax.swing.text.JTextComponent;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.ResourceLock;
import org.junit.jupiter.api.parallel.Resources;
import org.selectiverenderer.enricher.EventThread;
import org.selectiverenderer.testing.ShowsWindows;
import org.selectiverenderer.x3d.source.DocumentElement;
import org.selectiverenderer.x3d.source.ElementTree;

/** The fields of a prototype's instance, filled in by an author. */
@ShowsWindows
@Timeout(value = 120, unit = TimeUnit.SECONDS)
class PrototypeFormTest {
  private static final String SCENE =
      """
      <?xml version="1.0" encoding="UTF-8"?>
      <X3D profile='Immersive' version='4.0'><Scene>
        <ProtoDeclare name='Chair'>
          <ProtoInterface>
            <field name='colour' type='SFColor' accessType='inputOutput' value='0.6 0.3 0.1'
              appinfo='of the seat'/>
            <field name='gloss' type='SFFloat' accessType='inputOutput' value='0.2'/>
            <field name='name' type='SFString' accessType='inputOutput' value='oak'/>
            <field name='padded' type='SFBool' accessType='initializeOnly' value='false'/>
            <field name='labels' type='MFString' accessType='inputOutput' value='"old" "worn"'/>
            <field name='seat' type='SFNode' accessType='inputOutput'><Shape DEF='Seat'/></field>
            <field name='legs' type='MFNode' accessType='inputOutput'/>
          </ProtoInterface>
          <ProtoBody>
            <Shape><Appearance><Material>
              <IS><connect nodeField='diffuseColor' protoField='colour'/>
                <connect nodeField='shininess' protoField='gloss'/></IS>
            </Material></Appearance><Box/></Shape>
          </ProtoBody>
        </ProtoDeclare>
        <ExternProtoDeclare name='Lamp' url='"lamp.x3d#Lamp"'>
          <field name='light' type='SFColor' accessType='inputOutput'/>
        </ExternProtoDeclare>
        <ProtoInstance name='Chair' DEF='Chair1'/>
        <ProtoInstance name='Chair' DEF='Chair2'>
          <fieldValue name='legs'><Group DEF='Leg1'/><Group DEF='Leg2'/></fieldValue>
        </ProtoInstance>
        <ProtoInstance name='Lamp' DEF='Lamp1'/>
      </Scene></X3D>
      """;

  @TempDir Path folder;

  private FormWindowDriver open() throws Exception {
    return new FormWindowDriver(Files.writeString(folder.resolve("scene.x3d"), SCENE), false);
  }

  private static Object property(Component control, String key) {
    return EventThread.get(() -> ((JComponent) control).getClientProperty(key));
  }

  private static String text(FormWindowDriver window) {
    return EventThread.get(() -> window.session.document().text().toString());
  }

  @Test
  void aColourOfAnInstanceIsTypedMarkedWrittenAndUndoneInOneStep() throws Exception {
    try (FormWindowDriver window = open()) {
      window.select("Chair1");
      JTextComponent colour = (JTextComponent) window.named("fieldValue colour");
      assertThat(property(colour, "JTextField.placeholderText")).isEqualTo("0.6 0.3 0.1");
      assertThat(EventThread.get(() -> colour.getToolTipText()))
          .isEqualTo("SFColor, 0.6 0.3 0.1 by default, from 0, to 1 \u2013 of the seat");
      assertThat(property(colour, "JTextField.trailingComponent")).isInstanceOf(ColorSwatch.class);
      window.screenshot("form-instance", 1);
      window.fill(colour, "1 0 2");
      window.press(KeyEvent.VK_ENTER);
      assertThat(property(colour, "JComponent.outline")).isEqualTo("error");
      assertThat(text(window)).isEqualTo(SCENE);
      window.fill(colour, "1 0 0");
      window.press(KeyEvent.VK_TAB);
      assertThat(property(colour, "JComponent.outline")).isNull();
      assertThat(window.text("Chair1")).contains("<fieldValue name='colour' value='1 0 0'/>");
      assertThat(window.named("fieldValue colour")).isSameAs(colour); // the keyboard stays
      assertThat(EventThread.get(() -> window.session.document().history().names())).hasSize(1);
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(text(window)).isEqualTo(SCENE);
      assertThat(EventThread.get(() -> colour.getText())).isEmpty();
    }
  }

  @Test
  void aFieldWithTheNameOfAnAttributeIsAnotherOne() throws Exception {
    try (FormWindowDriver window = open()) {
      window.select("Chair1");
      JTextComponent own = (JTextComponent) window.named("field name");
      JTextComponent declared = (JTextComponent) window.named("fieldValue name");
      assertThat(EventThread.get(() -> own.getText())).isEqualTo("Chair");
      assertThat(EventThread.get(() -> declared.getAccessibleContext().getAccessibleName()))
          .isEqualTo("name of the prototype Chair");
      window.fill(declared, "elm");
      window.press(KeyEvent.VK_ENTER);
      assertThat(window.text("Chair1"))
          .startsWith("<ProtoInstance name='Chair' DEF='Chair1'>")
          .contains("<fieldValue name='name' value='elm'/>");
      JCheckBox padded = (JCheckBox) window.named("fieldValue padded");
      EventThread.edt(padded::doClick);
      assertThat(window.text("Chair1")).contains("<fieldValue name='padded' value='true'/>");
      EventThread.edt(((AbstractButton) window.named("reset fieldValue name"))::doClick);
      assertThat(window.text("Chair1")).doesNotContain("elm").contains("name='Chair'");
      assertThat(EventThread.get(padded::isSelected)).isTrue();
      EventThread.edt(((AbstractButton) window.named("reset name"))::doClick);
      assertThat(window.text("Chair1")).contains("name='Chair'");
      assertThat(window.messages).anyMatch(said -> said.contains("needs the name"));
    }
  }

  @Test
  void aValueGoesToAllSelectedOfTheKindWhereTheAuthorSaysSo() throws Exception {
    try (FormWindowDriver window = open()) {
      window.select("Chair1");
      JCheckBox others = (JCheckBox) window.named("otherNodes");
      assertThat(EventThread.get(others::isVisible)).isFalse();
      EventThread.edt(
          () -> {
            ElementTree tree = window.session.document().tree().orElseThrow();
            List<DocumentElement> all =
                List.of(
                    tree.named("Lamp1").orElseThrow(),
                    tree.named("Chair2").orElseThrow(),
                    tree.named("Chair1").orElseThrow());
            window.session.selectAll(all, this);
          });
      assertThat(EventThread.get(others::isVisible)).isTrue();
      JTextComponent gloss = (JTextComponent) window.named("fieldValue gloss");
      window.fill(gloss, "0.5");
      window.press(KeyEvent.VK_ENTER);
      assertThat(window.text("Chair1")).contains("name='gloss' value='0.5'");
      assertThat(window.text("Chair2")).doesNotContain("gloss");
      EventThread.edt(others::doClick);
      window.screenshot("form-instance-several", 1);
      window.fill(gloss, "0.75");
      window.press(KeyEvent.VK_ENTER);
      assertThat(window.text("Chair1")).contains("name='gloss' value='0.75'");
      assertThat(window.text("Chair2")).contains("name='gloss' value='0.75'");
      assertThat(window.text("Lamp1")).doesNotContain("gloss");
      EventThread.edt(() -> window.session.document().history().undo());
      EventThread.edt(() -> window.session.document().history().undo());
      assertThat(text(window)).isEqualTo(SCENE);
    }
  }

  @Test
  void nodesOfAFieldAreShownAndSelected() throws Exception {
    try (FormWindowDriver window = open()) {
      window.select("Chair2");
      assertThat(links(window, "fieldValue legs")).containsExactly("Group Leg1", "Group Leg2");
      assertThat(links(window, "fieldValue seat")).containsExactly("Shape Seat");
      window.screenshot("form-instance-nodes", 1);
      Component legs = window.named("fieldValue legs");
      AbstractButton second =
          EventThread.get(
              () ->
                  (AbstractButton)
                      FormWindowDriver.all(legs)
                          .filter(AbstractButton.class::isInstance)
                          .filter(c -> ((AbstractButton) c).getText().endsWith("Leg2"))
                          .findAny()
                          .orElseThrow());
      window.click(second);
      assertThat(
              EventThread.get(
                  () -> window.session.selection().map(DocumentElement::toString).orElseThrow()))
          .isEqualTo("Group Leg2");
    }
  }

  private static List<String> links(FormWindowDriver window, String name) {
    Component links = window.named(name);
    return EventThread.get(
        () ->
            FormWindowDriver.all(links)
                .filter(AbstractButton.class::isInstance)
                .map(c -> ((AbstractButton) c).getText())
                .toList());
  }

  @Test
  void theFormFollowsTheInterfaceAndSaysWhoHasTheDefaults() throws Exception {
    try (FormWindowDriver window = open()) {
      window.select("Lamp1");
      Component light = window.named("fieldValue light");
      assertThat(property(light, "JTextField.placeholderText"))
          .isEqualTo("default in the file of the prototype");
      window.select("Chair1");
      int gloss = SCENE.indexOf("<field name='gloss'");
      String age = "<field name='age' type='SFInt32' accessType='inputOutput'/>";
      EventThread.edt(() -> window.session.document().type(gloss, gloss, age));
      assertThat(window.named("fieldValue age").isShowing()).isTrue();
      int chair = text(window).indexOf("'Chair' DEF='Chair1'") + 1;
      EventThread.edt(() -> window.session.document().type(chair, chair + 5, "Lamp"));
      assertThat(window.named("fieldValue light").isShowing()).isTrue();
      JLabel head = (JLabel) window.named("fields of prototype");
      assertThat(EventThread.get(head::getText)).isEqualTo("Fields of the prototype Lamp");
    }
  }

  @Test
  @ResourceLock(Resources.LOCALE)
  void picturesInGreek() throws Exception {
    Locale before = Locale.getDefault(Locale.Category.DISPLAY);
    Locale.setDefault(Locale.Category.DISPLAY, Locale.forLanguageTag("el"));
    try (FormWindowDriver window = open()) {
      window.select("Chair2");
      JLabel head = (JLabel) window.named("fields of prototype");
      assertThat(EventThread.get(head::getText)).isEqualTo("Πεδία του πρωτοτύπου Chair");
      window.screenshot("form-instance-greek", 1);
    } finally {
      Locale.setDefault(Locale.Category.DISPLAY, before);
    }
  }
}
