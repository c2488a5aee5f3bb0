package org.selectiverenderer.validation.language;

import java.util.List;
import org.selectiverenderer.validation.Rule;

/** Declares the rules SR150 to SR159, about prototypes. */
final class PrototypeRules {
  private static final String GOOD =
      """
      <ProtoDeclare name='Chair'>
        <ProtoInterface>
          <field name='place' type='SFVec3f' accessType='inputOutput' value='0 0 0'/>
        </ProtoInterface>
        <ProtoBody>
          <Transform>
            <IS><connect nodeField='translation' protoField='place'/></IS>
          </Transform>
        </ProtoBody>
      </ProtoDeclare>
      <ProtoInstance name='Chair'><fieldValue name='place' value='1 0 0'/></ProtoInstance>""";

  static final Rule DECLARATION =
      Rule.error("SR151", "a ProtoDeclare needs {part}")
          .because("Without a name and a body there is nothing that an instance could show.")
          .bad("<ProtoDeclare name='Chair'/>")
          .good(GOOD)
          .see("X3D 4.0, 4.4.4");

  static final Rule UNKNOWN =
      Rule.error("SR152", "no prototype above has the name {name}{suggestion}")
          .because("An instance of a prototype that is not declared above it is left out.")
          .bad(GOOD.replace("<ProtoInstance name='Chair'>", "<ProtoInstance name='Chiar'>"))
          .good(GOOD)
          .see("X3D 4.0, 4.4.4");

  static final Rule UNKNOWN_FIELD =
      Rule.error("SR153", "the prototype {name} has no field {field}{suggestion}")
          .because("The value is left out, and the field keeps its default.")
          .bad(GOOD.replace("<fieldValue name='place'", "<fieldValue name='plaec'"))
          .good(GOOD)
          .see("X3D 4.0, 4.4.4");

  static final Rule CONNECT =
      Rule.error("SR154", "{fault}")
          .about("an IS that connects nothing, or fields of different type or access")
          .because(
              """
              IS connects a field of a node in a prototype's body with a field of the \
              prototype's interface; both must have the same type.""")
          .bad(GOOD.replace("protoField='place'", "protoField='plaec'"))
          .good(GOOD)
          .see("X3D 4.0, 4.4.4.2");

  static final Rule FIELD =
      Rule.error("SR155", "{fault}")
          .about("a field declaration that is not complete")
          .because("A field of an interface or a script has a name, a type and an accessType.")
          .bad(GOOD.replace("type='SFVec3f'", "type='Vec3f'"))
          .good(GOOD)
          .see("X3D 4.0, 4.4.4.2; X3D XML encoding, 4.3.8");

  static final Rule EXTERNAL =
      Rule.error("SR156", "{fault}")
          .about("an external prototype that cannot be read, or whose interface differs")
          .because(
              """
              Instances of a prototype that cannot be read are left out. Where its file and the \
              declaration here differ, the file is used. A declaration that no instance uses is \
              not read.""")
          .bad(
              """
              <ExternProtoDeclare name='Chair' url='"chiars.x3d#Chair"'/>
              <ProtoInstance name='Chair'/>""")
          .good(GOOD)
          .see("X3D 4.0, 4.4.5");

  static final Rule ITSELF =
      Rule.error("SR157", "the prototype {name} contains itself")
          .because("This would never end; the inner instance is left out.")
          .bad(
              """
              <ProtoDeclare name='Chair'>
                <ProtoBody><Group><ProtoInstance name='Chair'/></Group></ProtoBody>
              </ProtoDeclare>
              <ProtoInstance name='Chair'/>""")
          .good(GOOD)
          .see("X3D 4.0, 4.4.4.3");

  static final List<Rule> ALL =
      List.of(DECLARATION, UNKNOWN, UNKNOWN_FIELD, CONNECT, FIELD, EXTERNAL, ITSELF);

  private PrototypeRules() {}
}
