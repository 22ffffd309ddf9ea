// Box2D v3 (npm box2d3-wasm, where it is installed) on the scenes of the race. In the page it never sleeps: the other side
// never does either. All else is its own default.
'use strict';

(function (space) {
    const reach = 60; // how long a wall is to each side, and how thick [m]; Box2D has no half-space

    class Box2dSide {
        // `parcel`: {version, factory, code} of pack_box2d.py; the code may be bytes.
        static async of(parcel) {
            let bytes = parcel.code;
            if (typeof bytes === 'string') {
                const text = atob(bytes);
                bytes = new Uint8Array(text.length);
                for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
            }
            const side = new Box2dSide();
            side.box = await parcel.factory({wasmBinary: bytes, pthreadCount: 0, print: () => {}, printErr: () => {}});
            return side;
        }

        // `scene`: what race_scene() says (world_text.hpp). `stiffness` [Hz]: of contacts, which Box2D bounds by a quarter of its
        // sub-steps a second; 0: as it comes. The package can set none of joints.
        open(scene, substeps, sleep = false, stiffness = 0) {
            this.close();
            const {box} = this, vector = ([x, y]) => new box.b2Vec2(x, y);
            this.substeps = substeps;
            const def = box.b2DefaultWorldDef();
            def.gravity = vector(scene.gravity);
            def.enableSleep = sleep;
            if (stiffness) def.contactHertz = stiffness;
            this.world = box.b2CreateWorld(def);
            const ground = box.b2CreateBody(this.world, box.b2DefaultBodyDef());
            const surface = (friction, group) => {
                const made = box.b2DefaultShapeDef(), material = made.material;
                material.friction = friction; // of two: the root of their product, as the book's
                material.restitution = 0;
                made.material = material;
                if (group) {
                    const filter = made.filter;
                    filter.groupIndex = group;
                    made.filter = filter;
                }
                return made;
            };
            const polygon = (points, radius) => box.b2MakePolygon(box.b2ComputeHull(points.map(([x, y]) => ({x, y}))), radius);
            for (const [x, y, offset] of scene.walls) {
                const at = (along, depth) => [x * (offset - depth) - y * along, y * (offset - depth) + x * along];
                const wall = [at(reach, 0), at(-reach, 0), at(-reach, reach), at(reach, reach)];
                box.b2CreatePolygonShape(ground, surface(scene.friction, 0), polygon(wall, 0));
            }
            this.bodies = scene.bodies.map(one => {
                const body_def = box.b2DefaultBodyDef(), turn = new box.b2Rot();
                const moves = one.mass !== null, goes = one.u.some(v => v !== 0);
                body_def.type = moves ? box.b2BodyType.b2_dynamicBody : goes ? box.b2BodyType.b2_kinematicBody : box.b2BodyType.b2_staticBody;
                body_def.position = vector(one.x);
                turn.SetAngle(one.x[2]);
                body_def.rotation = turn;
                body_def.linearVelocity = vector(one.u);
                body_def.angularVelocity = one.u[2];
                const body = box.b2CreateBody(this.world, body_def);
                if (scene.touches) this.add_shape(body, surface(one.friction, one.group), one, polygon);
                if (!moves) return body;
                const mass = new box.b2MassData();
                mass.mass = one.mass;
                mass.rotationalInertia = one.inertia;
                mass.center = vector([0, 0]);
                box.b2Body_SetMassData(body, mass);
                return body;
            });
            for (const {a, b, at_a, at_b, angle, limits: [lower, upper], motor: [speed, torque]} of scene.pins) {
                const joint = box.b2DefaultRevoluteJointDef(), base = joint.base;
                const frame = (at, turn) => {
                    const made = new box.b2Transform(), level = new box.b2Rot();
                    level.SetAngle(turn);
                    made.p = vector(at);
                    made.q = level;
                    return made;
                };
                base.bodyIdA = a < 0 ? ground : this.bodies[a];
                base.bodyIdB = this.bodies[b];
                base.localFrameA = frame(at_a, angle);
                base.localFrameB = frame(at_b, 0);
                joint.base = base;
                if (lower !== null || upper !== null) {
                    const most = 0.99 * Math.PI;
                    joint.enableLimit = true;
                    joint.lowerAngle = lower === null ? -most : Math.max(lower, -most);
                    joint.upperAngle = upper === null ? most : Math.min(upper, most);
                }
                if (torque !== 0) {
                    joint.enableMotor = true;
                    joint.motorSpeed = speed;
                    joint.maxMotorTorque = torque;
                }
                box.b2CreateRevoluteJoint(this.world, joint);
            }
        }

        add_shape(body, surface, one, polygon) {
            const {box} = this, points = one.vertices;
            if (points.length === 1) {
                const circle = new box.b2Circle();
                circle.center = new box.b2Vec2(...points[0]);
                circle.radius = one.radius;
                box.b2CreateCircleShape(body, surface, circle);
            } else if (points.length === 2) {
                const capsule = new box.b2Capsule();
                capsule.center1 = new box.b2Vec2(...points[0]);
                capsule.center2 = new box.b2Vec2(...points[1]);
                capsule.radius = one.radius;
                box.b2CreateCapsuleShape(body, surface, capsule);
            } else box.b2CreatePolygonShape(body, surface, polygon(points, one.radius));
        }

        step(h) { this.box.b2World_Step(this.world, h, this.substeps); }

        // The velocity of a body whose path is given.
        drive(k, [x, y, spin]) {
            this.box.b2Body_SetLinearVelocity(this.bodies[k], new this.box.b2Vec2(x, y));
            this.box.b2Body_SetAngularVelocity(this.bodies[k], spin);
        }

        // (x, y, θ) of each body.
        positions(out) {
            this.bodies.forEach((body, i) => {
                const at = this.box.b2Body_GetPosition(body), turn = this.box.b2Body_GetRotation(body);
                out[3 * i] = at.x;
                out[3 * i + 1] = at.y;
                out[3 * i + 2] = turn.GetAngle();
                at.delete();
                turn.delete();
            });
        }

        close() {
            if (this.world) this.box.b2DestroyWorld(this.world);
            this.world = null;
        }
    }

    space.RigidBox2d = Box2dSide;
})(globalThis);
