// Jolt (npm jolt-physics, where it is installed) on the scenes in space of beside.mjs, by its public interface, without
// damping. All else is its own default.
'use strict';

(function (space) {
    const fixed_things = 0, moving_things = 1;

    class JoltSide {
        static async of(factory, bytes) {
            const side = new JoltSide();
            side.jolt = await factory({wasmBinary: bytes});
            return side;
        }

        // `scene`: what race_scene() says (space_text.hpp). `rounds`: iterations of velocities; 0: as they come.
        open(scene, substeps, sleep = false, rounds = 0) {
            this.close();
            const {jolt} = this;
            this.substeps = substeps;
            const settings = new jolt.JoltSettings();
            settings.mMaxWorkerThreads = 0; // all on this thread
            // What is fixed meets what moves, and what moves all.
            const pairs = new jolt.ObjectLayerPairFilterTable(2), layers = new jolt.BroadPhaseLayerInterfaceTable(2, 2);
            pairs.EnableCollision(fixed_things, moving_things);
            pairs.EnableCollision(moving_things, moving_things);
            for (const layer of [fixed_things, moving_things]) layers.MapObjectToBroadPhaseLayer(layer, new jolt.BroadPhaseLayer(layer));
            settings.mObjectLayerPairFilter = pairs;
            settings.mBroadPhaseLayerInterface = layers;
            settings.mObjectVsBroadPhaseLayerFilter = new jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
            this.world = new jolt.JoltInterface(settings);
            jolt.destroy(settings);
            this.system = this.world.GetPhysicsSystem();
            this.system.SetGravity(this.vector(scene.gravity));
            if (rounds) {
                const physics = this.system.GetPhysicsSettings();
                physics.mNumVelocitySteps = rounds;
                this.system.SetPhysicsSettings(physics);
            }
            // What a joint joins does not touch.
            const filter = new jolt.GroupFilterTable(scene.bodies.length + scene.walls.length);
            for (const {a, b} of scene.joints) if (a >= 0) filter.DisableCollision(a, b);
            const all = [...scene.bodies, ...scene.walls].map((one, k) => this.add(one, filter, k, sleep));
            this.bodies = all.slice(0, scene.bodies.length);
            for (const joint of scene.joints) this.join(joint);
            this.system.OptimizeBroadPhase();
        }

        vector([x, y, z]) { return new this.jolt.Vec3(x, y, z); }
        place([x, y, z]) { return new this.jolt.RVec3(x, y, z); }
        quaternion(q) {
            const length = Math.hypot(...q);
            return new this.jolt.Quat(...q.map(one => one / length));
        }

        shape_of({kind, size, radius}) {
            const {jolt} = this;
            if (kind === 'ball') return new jolt.SphereShape(radius);
            if (kind === 'box') {
                const half = size.map(one => one / 2);
                return new jolt.BoxShape(this.vector(half), Math.min(0.05, ...half)); // Jolt's own radius of edges
            }
            // Jolt's lie along y.
            const made = new jolt.RotatedTranslatedShapeSettings(new jolt.Vec3(0, 0, 0), this.quaternion([0, 0, Math.SQRT1_2, Math.SQRT1_2]),
                                                                 new jolt.CapsuleShapeSettings(size[0] / 2, radius));
            return made.Create().Get();
        }

        add(one, filter, number, sleep) {
            const {jolt} = this, moves = one.mass !== null, bodies = this.system.GetBodyInterface();
            const made = new jolt.BodyCreationSettings(this.shape_of(one), this.place(one.at), this.quaternion(one.turn),
                moves ? jolt.EMotionType_Dynamic : jolt.EMotionType_Static, moves ? moving_things : fixed_things);
            made.mFriction = one.friction;
            made.mAllowSleeping = sleep;
            made.mLinearDamping = made.mAngularDamping = 0;
            made.mCollisionGroup = new jolt.CollisionGroup(filter, 0, number);
            if (moves) {
                made.mLinearVelocity = this.vector(one.v);
                made.mAngularVelocity = this.vector(one.spin);
                made.mOverrideMassProperties = jolt.EOverrideMassProperties_MassAndInertiaProvided;
                const mass = made.mMassPropertiesOverride;
                mass.mMass = one.mass;
                mass.mInertia = jolt.Mat44.prototype.sScaleVec3(this.vector(one.inertia));
            }
            const body = bodies.CreateBody(made);
            bodies.AddBody(body.GetID(), moves ? jolt.EActivation_Activate : jolt.EActivation_DontActivate);
            jolt.destroy(made);
            return body;
        }

        join({a, b, at_a, at_b, frame_a, frame_b, hinge, twist, cone}) {
            const {jolt} = this, A = this.quaternion(frame_a), B = this.quaternion(frame_b), p = this.place(at_a), q = this.place(at_b);
            const copy = v => new jolt.Vec3(v.GetX(), v.GetY(), v.GetZ()); // what a call returns is good until the next
            let made;
            const within = (x, low, high) => Math.min(Math.max(x === null ? low : x, low), high);
            const limit = [twist && twist[0] !== null ? twist[0] : -Math.PI, twist && twist[1] !== null ? twist[1] : Math.PI];
            if (hinge) {
                made = new jolt.HingeConstraintSettings();
                made.mPoint1 = p, made.mPoint2 = q;
                made.mHingeAxis1 = copy(A.RotateAxisX()), made.mHingeAxis2 = copy(B.RotateAxisX());
                made.mNormalAxis1 = copy(A.RotateAxisY()), made.mNormalAxis2 = copy(B.RotateAxisY());
                if (twist) made.mLimitsMin = within(limit[0], -Math.PI, 0), made.mLimitsMax = within(limit[1], 0, Math.PI);
            } else if (twist) {
                made = new jolt.SwingTwistConstraintSettings();
                made.mPosition1 = p, made.mPosition2 = q;
                made.mTwistAxis1 = copy(A.RotateAxisX()), made.mTwistAxis2 = copy(B.RotateAxisX());
                made.mPlaneAxis1 = copy(A.RotateAxisY()), made.mPlaneAxis2 = copy(B.RotateAxisY());
                made.mNormalHalfConeAngle = made.mPlaneHalfConeAngle = cone === null ? Math.PI : Math.min(cone, Math.PI);
                made.mTwistMinAngle = within(limit[0], -Math.PI, Math.PI), made.mTwistMaxAngle = within(limit[1], -Math.PI, Math.PI);
            } else {
                made = new jolt.PointConstraintSettings();
                made.mPoint1 = p, made.mPoint2 = q;
            }
            made.mSpace = jolt.EConstraintSpace_LocalToBodyCOM;
            const first = a < 0 ? jolt.JoltInterface.prototype.sGetFixedToWorldBody() : this.bodies[a];
            this.system.AddConstraint(made.Create(first, this.bodies[b]));
        }

        step(h) { this.world.Step(h, this.substeps); }

        // (x, y, z) and a quaternion, its w last, of each body.
        positions(out) {
            this.bodies.forEach((body, k) => {
                const p = body.GetCenterOfMassPosition();
                out[7 * k] = p.GetX(), out[7 * k + 1] = p.GetY(), out[7 * k + 2] = p.GetZ();
                const q = body.GetRotation();
                out[7 * k + 3] = q.GetX(), out[7 * k + 4] = q.GetY(), out[7 * k + 5] = q.GetZ(), out[7 * k + 6] = q.GetW();
            });
        }

        close() {
            if (this.world) this.jolt.destroy(this.world);
            this.world = null;
        }
    }

    space.RigidJolt = JoltSide;
})(globalThis);
