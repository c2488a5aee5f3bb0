package org.selectiverenderer.browser.sai;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.web3d.x3d.sai.InvalidFieldException;
import org.web3d.x3d.sai.MFNode;
import org.web3d.x3d.sai.SFVec3f;
import org.web3d.x3d.sai.X3DChildNode;
import org.web3d.x3d.sai.X3DNode;
import org.web3d.x3d.sai.X3DNodeTypes;
import org.web3d.x3d.sai.X3DProtoInstance;
import org.web3d.x3d.sai.grouping.Group;
import org.web3d.x3d.sai.grouping.Transform;

/** An application holds an instance of a prototype by its interface (X3D 4.0, 4.4.4.1). */
class ProtoInstanceAccessTest {
  private static final String SCENE =
      """
      <ProtoDeclare name='Door'>
        <ProtoInterface>
          <field name='place' type='SFVec3f' accessType='inputOutput' value='1 2 3'/>
          <field name='width' type='SFFloat' accessType='initializeOnly' value='0.9'/>
        </ProtoInterface>
        <ProtoBody><Transform><IS><connect nodeField='translation' protoField='place'/></IS>
        </Transform></ProtoBody>
      </ProtoDeclare>
      <Group DEF='House'><ProtoInstance name='Door' DEF='Front'/></Group>
      <Transform DEF='Other'/>
      <ROUTE fromNode='Front' fromField='place' toNode='Other' toField='translation'/>
      """;

  private static float[] value(X3DNode node, String field) {
    float[] value = new float[3];
    ((SFVec3f) node.getField(field)).getValue(value);
    return value;
  }

  @Test
  void showItsFieldsAndNoneOfTheBody() {
    try (SaiFixture sai = SaiFixture.showing(SCENE)) {
      X3DNode door = sai.node("Front");

      assertThat(door).isInstanceOf(X3DProtoInstance.class).isInstanceOf(X3DChildNode.class);
      assertThat(door).isNotInstanceOf(Transform.class);
      assertThat(door.getNodeName()).isEqualTo("Door");
      assertThat(door.getNodeType()).contains(X3DNodeTypes.X3DProtoInstance);
      assertThat(door.getFieldDefinitions())
          .extracting("name")
          .containsExactly("place", "width", "metadata");
      assertThat(value(door, "place")).containsExactly(1, 2, 3);
      assertThat(((org.web3d.x3d.sai.SFFloat) door.getField("width")).getValue()).isEqualTo(0.9f);
      assertThatThrownBy(() -> door.getField("translation"))
          .isInstanceOf(InvalidFieldException.class)
          .hasMessage("Door has no field translation");
    }
  }

  @Test
  void passValuesBothWays() {
    try (SaiFixture sai = SaiFixture.showing(SCENE)) {
      X3DNode door = sai.node("Front");
      List<String> heard = new ArrayList<>();
      SFVec3f place = (SFVec3f) door.getField("place");
      place.addX3DEventListener(event -> heard.add("at " + value(door, "place")[0]));
      sai.scene().addRoute(door, "place_changed", sai.node("Other"), "scale");
      sai.step();

      place.setValue(new float[] {7, 8, 9});
      sai.step();

      assertThat(value(sai.node("Other"), "scale")).containsExactly(7, 8, 9);
      assertThat(value(sai.node("Other"), "translation")).containsExactly(7, 8, 9);
      assertThat(value(sai.browser.bodyOf(door), "translation")).containsExactly(7, 8, 9);
      assertThat(heard).containsExactly("at 7.0");
    }
  }

  @Test
  void standInTheirParentsAsBefore() {
    try (SaiFixture sai = SaiFixture.showing(SCENE)) {
      X3DNode door = sai.node("Front");
      Group house = sai.node("House", Group.class);
      X3DNode[] children = new X3DNode[1];
      house.getChildren(children);

      assertThat(children).containsExactly(door);
      assertThat(sai.browser.bodyOf(door)).isInstanceOf(Transform.class);
      assertThat(sai.browser.bodyOf(house)).isSameAs(house);

      ((MFNode) house.getField("children")).clear();
      sai.step();
      assertThat(house.getNumChildren()).isZero();

      house.addChildren(new X3DNode[] {door});
      sai.step();
      house.getChildren(children);
      assertThat(children).containsExactly(door);
    }
  }
}
